#pragma once
// Qt's words need an application; it sees none of our arguments.

#include "app/farol-cli/walk_inputs.h"

#include <QCoreApplication>

#include <string>

namespace farol::cli {

class WordsApplication {
public:
    explicit WordsApplication(const std::string& language) : m_application(m_count, m_arguments) {
        QCoreApplication::setApplicationName(QStringLiteral("Farol"));
        chooseLanguage(language);
    }

private:
    char m_name[10] = "farol-cli";
    char* m_arguments[2] = {m_name, nullptr};
    int m_count = 1;
    QCoreApplication m_application;
};

} // namespace farol::cli
