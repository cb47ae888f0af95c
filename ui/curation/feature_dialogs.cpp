#include "ui/curation/feature_dialogs.h"

#include "core/building/edit.h"
#include "ui/convert/convert.h"
#include "ui/models/words.h"
#include "ui/parts/place_chooser.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace farol::ui {

namespace {

constexpr std::array kRegionKinds{building::RegionKind::Room,     building::RegionKind::Corridor,
                                  building::RegionKind::Hall,     building::RegionKind::Stairwell,
                                  building::RegionKind::Elevator, building::RegionKind::Toilet,
                                  building::RegionKind::Outside,  building::RegionKind::Other};
constexpr std::array kAccessKinds{building::AccessKind::Door,      building::AccessKind::Opening,
                                  building::AccessKind::Stairs,    building::AccessKind::Elevator,
                                  building::AccessKind::Escalator, building::AccessKind::Ramp,
                                  building::AccessKind::Window,    building::AccessKind::Other};

template <class Kinds, class Kind, class Word>
QComboBox* kindBox(const Kinds& kinds, Kind current, Word word, QWidget* parent) {
    auto* box = new QComboBox(parent);
    for (const auto kind : kinds) box->addItem(word(kind), static_cast<int>(kind));
    box->setCurrentIndex(box->findData(static_cast<int>(current)));
    return box;
}

template <class Kind>
Kind chosenKind(const QComboBox* box) {
    return static_cast<Kind>(box->currentData().toInt());
}

/// 0 to 359; -1: any.
int wholeDegrees(const std::optional<Radians>& heading) {
    if (!heading) return -1;
    return static_cast<int>(((std::lround(toDegrees(*heading)) % 360) + 360) % 360);
}

std::string trimmed(const QLineEdit* edit) {
    return toUtf8(edit->text().trimmed());
}

} // namespace

FeatureDialog::FeatureDialog(const QString& title, QWidget* parent)
    : QDialog(parent), m_form(new QFormLayout) {
    setWindowTitle(title);
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_form);
    setMinimumWidth(420);
}

void FeatureDialog::addRow(const QString& name, QWidget* field, const QString& tip) {
    auto* label = new QLabel(tr("%1:").arg(name), this);
    QWidget* named = field->focusProxy() ? field->focusProxy() : field;
    label->setBuddy(named);
    named->setAccessibleName(name);
    named->setToolTip(tip);
    m_form->addRow(label, field);
}

QLineEdit* FeatureDialog::text(const QString& name, const std::string& value, const QString& tip) {
    auto* edit = new QLineEdit(toQString(value), this);
    addRow(name, edit, tip);
    return edit;
}

QCheckBox* FeatureDialog::tick(const QString& name, bool value, const QString& tip) {
    auto* box = new QCheckBox(name, this);
    box->setChecked(value);
    box->setAccessibleName(name);
    box->setToolTip(tip);
    m_form->addRow(QString(), box);
    return box;
}

QDoubleSpinBox* FeatureDialog::metres(const QString& name, const std::optional<double>& value,
                                      const QString& tip) {
    auto* box = new QDoubleSpinBox(this);
    box->setRange(0.0, 100.0);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(QStringLiteral(" m"));
    box->setSpecialValueText(tr("not known"));
    box->setValue(value.value_or(0.0));
    addRow(name, box, tip);
    return box;
}

QDoubleSpinBox* FeatureDialog::place(const QString& name, double value, const QString& tip) {
    auto* box = new QDoubleSpinBox(this);
    box->setRange(-1e8, 1e8);
    box->setDecimals(2);
    box->setSingleStep(0.1);
    box->setSuffix(QStringLiteral(" m"));
    box->setGroupSeparatorShown(true);
    box->setValue(value);
    addRow(name, box, tip);
    return box;
}

std::optional<double> FeatureDialog::known(const QDoubleSpinBox* box, const std::optional<double>& before) {
    if (before && std::abs(*before - box->value()) < 0.006) return before; // untouched: stays exact
    return box->value() > 0.0 ? std::optional<double>(box->value()) : std::nullopt;
}

void FeatureDialog::finish() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout()->addWidget(buttons);
}

RegionDialog::RegionDialog(building::Region region, QWidget* parent)
    : FeatureDialog(tr("Region %1").arg(toQString(region.id.value)), parent), m_region(std::move(region)) {
    m_name = text(tr("Name"), m_region.name, tr("What is spoken"));
    m_ref = text(tr("Number"), m_region.ref, tr("The number on the door"));
    m_kind = kindBox(kRegionKinds, m_region.kind, Words::regionKind, this);
    addRow(tr("Kind"), m_kind, tr("What sort of place it is"));
    m_restricted = tick(tr("Restricted"), m_region.restricted, tr("Not open to everyone"));
    finish();
}

building::Region RegionDialog::region() const {
    building::Region region = m_region;
    region.name = trimmed(m_name);
    region.ref = trimmed(m_ref);
    region.kind = chosenKind<building::RegionKind>(m_kind);
    if (region.kind != building::RegionKind::Other) region.kindText.clear();
    region.restricted = m_restricted->isChecked();
    return region;
}

AccessDialog::AccessDialog(const std::shared_ptr<const building::Building>& building, building::Access access,
                           QWidget* parent)
    : FeatureDialog(tr("Door or passage %1").arg(toQString(access.id.value)), parent),
      m_access(std::move(access)) {
    m_regions.setBuilding(building);
    m_kind = kindBox(kAccessKinds, m_access.kind, Words::accessKind, this);
    addRow(tr("Kind"), m_kind, tr("What sort of passage it is"));
    const auto side = [&](const QString& name, const RegionId& region) {
        auto* chooser = new PlaceChooser(m_regions, PlaceChooser::Purpose::Side, this);
        if (building->region(region)) chooser->setChosen(region);
        addRow(name, chooser, tr("Type part of a name, room number or level, then choose"));
        return chooser;
    };
    m_sideA = side(tr("One side"), m_access.regionA);
    m_sideB = side(tr("Other side"), m_access.regionB);
    m_oneWay = new QComboBox(this);
    m_oneWay->addItems({tr("both ways"), tr("from the one side to the other only"),
                        tr("from the other side to the one only")});
    m_oneWay->setCurrentIndex(static_cast<int>(m_access.oneWay));
    addRow(tr("Direction"), m_oneWay, tr("Which way one can pass"));
    m_width = metres(tr("Width"), m_access.widthM, tr("How wide the door is"));
    m_steps = new QSpinBox(this);
    m_steps->setRange(-1, 1000);
    m_steps->setSpecialValueText(tr("not known"));
    m_steps->setValue(m_access.steps.value_or(-1));
    addRow(tr("Steps"), m_steps, tr("How many steps the stairs have"));
    const Point2 middle = m_access.midpoint();
    m_x = place(tr("East"), middle.x, tr("Place on the map, metres to the east"));
    m_y = place(tr("North"), middle.y, tr("Place on the map, metres to the north"));
    m_closed = tick(tr("Closed"), m_access.closed, tr("Nobody can pass"));
    finish();
}

building::Access AccessDialog::access() const {
    building::Access access = m_access;
    access.kind = chosenKind<building::AccessKind>(m_kind);
    if (access.kind != building::AccessKind::Other) access.kindText.clear();
    access.regionA = m_sideA->chosen().value_or(RegionId());
    access.regionB = m_sideB->chosen().value_or(RegionId());
    access.oneWay = static_cast<building::OneWay>(m_oneWay->currentIndex());
    access.widthM = known(m_width, m_access.widthM);
    access.steps = m_steps->value() >= 0 ? std::optional<int>(m_steps->value()) : std::nullopt;
    access.closed = m_closed->isChecked();
    const Point2 by = Point2{m_x->value(), m_y->value()} - m_access.midpoint();
    if (length(by) > 0.006) // a spin box holds centimetres: what was not touched stays exact
        for (Point2& point : access.line) point = point + by;
    return access;
}

LandmarkDialog::LandmarkDialog(const std::shared_ptr<const building::Building>& building,
                               building::Landmark landmark, QWidget* parent)
    : FeatureDialog(tr("Landmark %1").arg(toQString(landmark.id.value)), parent),
      m_building(building),
      m_landmark(std::move(landmark)) {
    m_kind = kindBox(allKinds(), m_landmark.kind, Phrasebook::kindWord, this);
    addRow(tr("Kind"), m_kind, tr("What it is"));
    m_text = text(tr("Text"), m_landmark.text, tr("What can be read on it"));
    m_template = text(tr("Trained as"), m_landmark.templateId.value,
                      tr("The name under which its appearance was trained"));
    m_faces = new QSpinBox(this);
    m_faces->setRange(-1, 359);
    m_faces->setWrapping(true);
    m_faces->setSuffix(QStringLiteral("°"));
    m_faces->setSpecialValueText(tr("any"));
    m_faces->setValue(wholeDegrees(m_landmark.heading));
    addRow(tr("Faces"), m_faces, tr("The way it faces: 0 is east, 90 north, 180 west, 270 south"));
    m_height = metres(tr("Height above the floor"), m_landmark.heightM, tr("Of its middle"));
    m_width = metres(tr("Width"), m_landmark.widthM, tr("How wide it is: its distance is told from that"));
    m_tall = metres(tr("Its own height"), m_landmark.tallM, tr("How tall it is"));
    m_x = place(tr("East"), m_landmark.position.x, tr("Place on the map, metres to the east"));
    m_y = place(tr("North"), m_landmark.position.y, tr("Place on the map, metres to the north"));
    finish();
}

building::Landmark LandmarkDialog::landmark() const {
    building::Landmark landmark = m_landmark;
    landmark.kind = chosenKind<Kind>(m_kind);
    if (landmark.kind != Kind::Other) landmark.kindText.clear();
    landmark.text = trimmed(m_text);
    landmark.templateId = TemplateId(trimmed(m_template));
    if (m_faces->value() < 0)
        landmark.heading.reset();
    else if (m_faces->value() != wholeDegrees(m_landmark.heading)) // untouched: stays exact
        landmark.heading = fromDegrees(m_faces->value());
    landmark.heightM = known(m_height, m_landmark.heightM);
    landmark.widthM = known(m_width, m_landmark.widthM);
    landmark.tallM = known(m_tall, m_landmark.tallM);
    const Point2 at{m_x->value(), m_y->value()};
    if (distance(at, m_landmark.position) > 0.006) return building::moved(*m_building, landmark, at);
    return landmark;
}

} // namespace farol::ui
