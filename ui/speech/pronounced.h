#pragma once
// A sentence as voices read it aright: what is shown stays as it is.

#include <QString>

namespace farol::ui::spoken {

/// Voices read "2-14" as "two minus fourteen", "1.º andar" as "one masculine ordinal floor", "1.204" as a
/// thousand and some, and rest after "Lab." as at the end of a sentence. `language`: "pt", "pt_BR".
QString pronounced(QString text, const QString& language);

} // namespace farol::ui::spoken
