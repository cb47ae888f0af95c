// The steps that change the library: change, merge, split, delete.

#include "ui/convert/convert.h"
#include "ui/training/edit_template_dialog.h"
#include "ui/training/library_panel.h"
#include "ui/training/training_page.h"
#include "ui/training/training_words.h"

#include <QComboBox>
#include <QInputDialog>

namespace farol::ui {

namespace {

QString nameOf(const recognition::Template& entry) {
    return toQString(entry.name.empty() ? entry.id.value : entry.name);
}

} // namespace

void TrainingPage::edit() {
    if (chosen() == nullptr) return;
    auto* form = new EditTemplateDialog(*chosen(), this);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form, index = *m_panel->chosen(), before = *chosen()] {
        m_document.change(
            tr("Change “%1”").arg(nameOf(before)),
            [index, after = form->changed(before)](const recognition::LandmarkLibrary& library) {
                return recognition::change(library, index, after);
            });
    });
    form->open();
}

void TrainingPage::merge() {
    if (chosen() == nullptr) return;
    const std::size_t into = *m_panel->chosen();
    QStringList names;
    std::vector<std::size_t> rows;
    const auto& templates = m_document.library()->templates;
    for (std::size_t i = 0; i < templates.size(); ++i) {
        if (i == into || (templates[i].kind == Kind::Place) != (templates[into].kind == Kind::Place))
            continue;
        const QString id = toQString(templates[i].id.value);
        names << (nameOf(templates[i]) == id ? id : tr("%1 (%2)").arg(nameOf(templates[i]), id));
        rows.push_back(i);
    }
    if (names.isEmpty()) return;
    auto* ask = new QInputDialog(this);
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setWindowTitle(tr("Merge landmarks"));
    ask->setLabelText(
        tr("The views of this landmark go to “%1”, and it is deleted:").arg(nameOf(templates[into])));
    ask->setComboBoxItems(names);
    ask->setComboBoxEditable(false);
    for (auto* list : ask->findChildren<QComboBox*>()) list->setAccessibleName(ask->labelText());
    connect(ask, &QInputDialog::textValueSelected, this, [this, into, rows, names](const QString& text) {
        const qsizetype at = names.indexOf(text);
        if (at < 0) return;
        m_document.change(tr("Merge landmarks"), [into, from = rows[static_cast<std::size_t>(at)]](
                                                     const recognition::LandmarkLibrary& library) {
            return recognition::merged(library, into, from);
        });
    });
    ask->open();
}

void TrainingPage::split() {
    const std::vector<std::size_t> views = m_panel->chosenViews();
    if (chosen() == nullptr || views.empty()) return;
    auto* ask = new QInputDialog(this);
    ask->setAttribute(Qt::WA_DeleteOnClose);
    ask->setWindowTitle(tr("Split the landmark"));
    ask->setLabelText(tr("Name of the landmark that the %n chosen view(s) become:", nullptr,
                         static_cast<int>(views.size())));
    ask->setTextValue(nameOf(*chosen()) + QStringLiteral(" 2"));
    connect(ask, &QInputDialog::textValueSelected, this,
            [this, views, index = *m_panel->chosen()](const QString& text) {
                const TemplateId id(toUtf8(TrainingWords::idFrom(text)));
                m_document.change(tr("Split the landmark"), [index, views, id, name = toUtf8(text.trimmed())](
                                                                const recognition::LandmarkLibrary& library) {
                    auto step = recognition::split(library, index, views, id);
                    if (step) step->back().after->name = name;
                    return step;
                });
            });
    ask->open();
}

void TrainingPage::removeViews() {
    const std::vector<std::size_t> views = m_panel->chosenViews();
    if (chosen() == nullptr || views.empty()) return;
    m_document.change(tr("Delete views"),
                      [views, index = *m_panel->chosen()](const recognition::LandmarkLibrary& library) {
                          return recognition::withoutViews(library, index, views);
                      });
}

void TrainingPage::remove() {
    if (chosen() == nullptr) return;
    m_document.change(tr("Delete “%1”").arg(nameOf(*chosen())),
                      [index = *m_panel->chosen()](
                          const recognition::LandmarkLibrary& library) -> Result<recognition::LibraryStep> {
                          return recognition::removal(library, index);
                      });
}

} // namespace farol::ui
