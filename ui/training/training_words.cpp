#include "ui/training/training_words.h"

#include "ui/convert/convert.h"

#include <QLocale>

namespace farol::ui {

using recognition::Advice;

namespace {

constexpr double kFarEnoughPx = 100.0; // a landmark that is lost before it is this small is seldom found

QString namesIn(const std::map<std::string, int>& names) {
    QStringList list;
    for (const auto& [name, times] : names) list << toQString(name);
    return list.join(QStringLiteral(", "));
}

} // namespace

QString TrainingWords::advice(Advice advice) {
    switch (advice) {
    case Advice::TooDark:
        return tr("Too dark. Switch on a light.");
    case Advice::TooBright:
        return tr("Too bright. Turn away from the window or the lamp.");
    case Advice::Blurred:
        return tr("Blurred. Hold the camera still, or wait until it is sharp.");
    case Advice::Nearer:
        return tr("Too small in the picture. Go nearer.");
    case Advice::FewFeatures:
        return tr("Too little detail inside the outline. Go nearer, or choose something with more detail.");
    case Advice::BadOutline:
        return tr("The corners cross. Set them clockwise from the top left.");
    case Advice::Squarely:
        return tr("Next: straight from the front, about 2 metres away.");
    case Advice::FromLeft:
        return tr("Next: from the left, at an angle.");
    case Advice::FromRight:
        return tr("Next: from the right, at an angle.");
    case Advice::FromFarther:
        return tr("Next: from farther away, about twice as far.");
    case Advice::AnotherSpot:
        return tr("Next: the same view from a step aside, or a step nearer.");
    case Advice::Enough:
        break;
    }
    return tr("These views are enough. More do no harm.");
}

QStringList TrainingWords::health(const recognition::TemplateCheck& check, Kind kind) {
    QStringList lines;
    if (check.tested == 0)
        lines << tr("There is only one view: add another, so that it can be tried.");
    else
        lines << tr("Found in %1 of its %2 views by the others.").arg(check.found).arg(check.tested);
    const QLocale locale;
    if (check.shown > 0 && check.smallestPx > 0.0) {
        QString text = check.farthestM ? tr("Found from up to about %1 m (%2 pixels).")
                                             .arg(locale.toString(*check.farthestM, 'f', 1))
                                             .arg(locale.toString(check.smallestPx, 'f', 0))
                                       : tr("Found down to a size of %1 pixels in the picture; give its real "
                                            "size to learn how far that is.")
                                             .arg(locale.toString(check.smallestPx, 'f', 0));
        lines << text;
        lines << (check.widestDegrees > 0.0
                      ? tr("Found at angles of up to %1 degrees.")
                            .arg(locale.toString(check.widestDegrees, 'f', 0))
                      : tr("Not found at an angle. Add views from the left and the right."));
    } else if (check.shown == 0 && kind != Kind::Place) {
        lines << tr("No view is straight from the front: add one, to learn from how far it is found.");
    } else if (check.shown > 0) {
        lines << tr("Never found when shown smaller or turned. Choose something with more detail.");
    }
    if (!check.confusedWith.empty()) lines << tr("Taken for another: %1.").arg(namesIn(check.confusedWith));
    if (!check.seenIn.empty()) lines << tr("Others are taken for it: %1.").arg(namesIn(check.seenIn));
    if (check.confusedWith.empty() && check.seenIn.empty()) lines << tr("Confused with none of the others.");
    return lines;
}

bool TrainingWords::worrying(const recognition::TemplateCheck& check) {
    const bool lost = check.tested > 0 && check.found < check.tested;
    const bool near = check.shown > 0 && (check.smallestPx <= 0.0 || check.smallestPx > kFarEnoughPx);
    return lost || near || !check.confusedWith.empty() || !check.seenIn.empty();
}

QString TrainingWords::verdict(const recognition::TemplateCheck& check) {
    if (!check.confusedWith.empty()) return tr("confused with %1").arg(namesIn(check.confusedWith));
    if (!check.seenIn.empty()) return tr("confused with %1").arg(namesIn(check.seenIn));
    if (check.shown > 0 && check.smallestPx <= 0.0) return tr("hard to find");
    if (check.shown > 0 && check.smallestPx > kFarEnoughPx) return tr("found from near only");
    if (check.tested > 0 && check.found < check.tested)
        return tr("%1 of %2 views found again").arg(check.found).arg(check.tested);
    if (check.tested == 0) return tr("one view only");
    return tr("good");
}

QString TrainingWords::idFrom(const QString& name) {
    QString id;
    for (const QChar letter : name.normalized(QString::NormalizationForm_D)) {
        if (letter.category() == QChar::Mark_NonSpacing) continue;
        if (letter.isLetterOrNumber())
            id += letter.toLower();
        else if (!id.isEmpty() && !id.endsWith(QLatin1Char('-')))
            id += QLatin1Char('-');
    }
    while (id.endsWith(QLatin1Char('-'))) id.chop(1);
    return id;
}

} // namespace farol::ui
