// Words that would do nothing as the others stand: each ends in a sentence, before any work.
#include <CLI/CLI.hpp> // first: it has a member called `check`, as error.hpp has a macro

#include "engine/app/cli_words.hpp"

namespace afterglow
{
void refuseIdle(const std::string& word, const OtherWord& other)
{
    throw CLI::ValidationError(
        word + " does nothing " +
        (other.said ? "beside " + other.word + ": leave one of them out" : "without " + other.word + ": leave it out, or add that"));
}

static void refuseEach(const CLI::App& verb, const OtherWord& other, const std::vector<std::string>& words)
{
    for (const std::string& word : words)
        if (verb.count(word) > 0) refuseIdle(word, other);
}

void obeyedWith(const CLI::App& verb, const OtherWord& other, const std::vector<std::string>& words)
{
    if (!other.said) refuseEach(verb, other, words);
}

void obeyedWithout(const CLI::App& verb, const OtherWord& other, const std::vector<std::string>& words)
{
    if (other.said) refuseEach(verb, other, words);
}

std::vector<std::string> wordsOf(const CLI::App& verb, const std::string& group)
{
    std::vector<std::string> words;
    for (const CLI::Option* option : verb.get_options())
        if (option->get_group() == group) words.push_back(option->get_name());
    return words;
}

std::string saidTwice(const CLI::App& app)
{
    for (const CLI::App* verb : app.get_subcommands())
        for (const CLI::Option* option : verb->get_options())
            if (option->get_items_expected_max() > 0 && option->count() > std::size_t(option->get_items_expected_max())) // not a flag
                return option->get_name();
    return "";
}
}
