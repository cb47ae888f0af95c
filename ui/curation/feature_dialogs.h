#pragma once
// Forms for one region, access or landmark. They answer the changed value; the document decides whether it
// makes sense.

#include "core/building/building.h"
#include "ui/models/region_model.h"

#include <QDialog>

#include <memory>
#include <optional>
#include <string>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QDoubleSpinBox;
class QFormLayout;
class QLineEdit;
class QSpinBox;

namespace farol::ui {

class PlaceChooser;

/// The frame that the three forms share: rows with names, OK and Cancel.
class FeatureDialog : public QDialog {
    Q_OBJECT

protected:
    explicit FeatureDialog(const QString& title, QWidget* parent);

    /// `name` labels the field and is what a screen reader says.
    void addRow(const QString& name, QWidget* field, const QString& tip);
    QLineEdit* text(const QString& name, const std::string& value, const QString& tip);
    QCheckBox* tick(const QString& name, bool value, const QString& tip);
    /// The lowest value means "not known".
    QDoubleSpinBox* metres(const QString& name, const std::optional<double>& value, const QString& tip);
    /// A coordinate.
    QDoubleSpinBox* place(const QString& name, double value, const QString& tip);
    void finish(); ///< buttons; the first field gets the focus

    static std::optional<double> known(const QDoubleSpinBox* box, const std::optional<double>& before);

private:
    QFormLayout* m_form;
};

class RegionDialog : public FeatureDialog {
    Q_OBJECT

public:
    RegionDialog(building::Region region, QWidget* parent = nullptr);

    building::Region region() const;

private:
    building::Region m_region;
    QLineEdit *m_name, *m_ref;
    QComboBox* m_kind;
    QCheckBox* m_restricted;
};

class AccessDialog : public FeatureDialog {
    Q_OBJECT

public:
    AccessDialog(const std::shared_ptr<const building::Building>& building, building::Access access,
                 QWidget* parent = nullptr);

    building::Access access() const;

private:
    building::Access m_access;
    RegionModel m_regions;
    QComboBox *m_kind, *m_oneWay;
    PlaceChooser *m_sideA, *m_sideB;
    QDoubleSpinBox *m_width, *m_x, *m_y;
    QSpinBox* m_steps;
    QCheckBox* m_closed;
};

class LandmarkDialog : public FeatureDialog {
    Q_OBJECT

public:
    LandmarkDialog(const std::shared_ptr<const building::Building>& building, building::Landmark landmark,
                   QWidget* parent = nullptr);

    /// Its region follows the place, when that was changed.
    building::Landmark landmark() const;

private:
    std::shared_ptr<const building::Building> m_building;
    building::Landmark m_landmark;
    QComboBox* m_kind;
    QLineEdit *m_text, *m_template;
    QSpinBox* m_faces;
    QDoubleSpinBox *m_height, *m_width, *m_tall, *m_x, *m_y;
};

} // namespace farol::ui
