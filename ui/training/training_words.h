#pragma once
// What the coach and the checks say, in words.

#include "core/recognition/library_check.h"
#include "core/recognition/view_coach.h"

#include <QCoreApplication>
#include <QString>

namespace farol::ui {

class TrainingWords {
    Q_DECLARE_TR_FUNCTIONS(farol::ui::TrainingWords)

public:
    static QString advice(recognition::Advice advice);
    /// Sentences about one template: found again, how far, how far aside, confused with what.
    static QStringList health(const recognition::TemplateCheck& check, Kind kind);
    /// The same in a few words: "good", "confused with poster-2", "hard to find".
    static QString verdict(const recognition::TemplateCheck& check);
    static bool worrying(const recognition::TemplateCheck& check);
    /// Letters, digits and dashes of a name: what maps call it.
    static QString idFrom(const QString& name);
};

} // namespace farol::ui
