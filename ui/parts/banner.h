#pragma once
// Messages that do not stand in the way: a strip above the page, with a button where something can be done.

#include <QFrame>
#include <QHash>
#include <QString>

#include <functional>

class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace farol::ui {

enum class BannerKind { Note, Warning, Problem };

struct BannerText {
    BannerKind kind = BannerKind::Note;
    QString text;
    QString action; ///< label of the button; empty: none
    std::function<void()> act;
    bool closable = true;
};

class Banner : public QFrame {
    Q_OBJECT

public:
    explicit Banner(QWidget* parent = nullptr);

    void show(BannerText text);
    QString text() const;
    void colour(); ///< by the palette of what it stands in

Q_SIGNALS:
    void closed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QLabel* m_kind;
    QLabel* m_label;
    QPushButton* m_action;
    QToolButton* m_close;
    BannerText m_text;
};

/// One strip per key: a newer message of the same key replaces the older one.
class BannerStack : public QWidget {
    Q_OBJECT

public:
    explicit BannerStack(QWidget* parent = nullptr);

    void show(const QString& key, BannerText text);
    void hide(const QString& key);
    bool shows(const QString& key) const { return m_banners.contains(key); }
    QString text(const QString& key) const;

protected:
    void changeEvent(QEvent* event) override;

private:
    QVBoxLayout* m_layout;
    QHash<QString, Banner*> m_banners;
};

} // namespace farol::ui
