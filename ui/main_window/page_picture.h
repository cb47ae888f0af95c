#pragma once
// A picture of a page as it is now, with its parts numbered, for the help: always in the language and the
// colours of the window, and with what is open in it.

#include <QPixmap>
#include <QStringList>

class QWidget;

namespace farol::ui {

struct PagePicture {
    QPixmap picture;   ///< `width` pixels wide on a plain screen; the n-th part bears the number n + 1
    QStringList parts; ///< their accessible names, from the top to the bottom and from the left to the right
};

/// The parts are the innermost named widgets that take more than a hundredth of the page. A page that is not
/// shown is drawn as it would be; one without a size gives an empty picture.
PagePicture pictureOf(QWidget& page, int width);

} // namespace farol::ui
