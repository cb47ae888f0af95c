#pragma once
// The form of one option struct of core: a row for each figure, with its default, and a button that takes all
// back.

#include "ui/settings/option_fields.h"
#include "ui/settings/settings.h"

#include <QWidget>

#include <functional>
#include <vector>

class QFormLayout;
class QPushButton;

namespace farol::ui {

class OptionForm : public QWidget {
    Q_OBJECT

public:
    /// `about`: a sentence above the rows.
    template <class Options>
    OptionForm(const Settings& settings, const std::vector<OptionField<Options>>& fields,
               const QString& about, QWidget* parent)
        : QWidget(parent) {
        build(about);
        const Options usual;
        for (const OptionField<Options>& field : fields)
            addRow(settings, {QString::fromLatin1(field.key), OptionFields::tr(field.label),
                              QString::fromLatin1(field.unit), field.in(usual), field.low, field.high,
                              field.step, field.yesOrNo(), field.whole()});
    }

    void store(Settings& settings) const; ///< only what is not as usual
    void takeBack();                      ///< to what the program has

private:
    struct Row {
        QString key, label, unit;
        double usual, low, high, step;
        bool yesOrNo, whole;
    };
    struct Shown {
        Row row;
        std::function<double()> value;
        std::function<void(double)> set;
    };

    void build(const QString& about);
    void addRow(const Settings& settings, const Row& row);

    QFormLayout* m_form;
    QPushButton* m_reset;
    std::vector<Shown> m_rows;
};

} // namespace farol::ui
