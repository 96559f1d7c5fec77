namespace afterglow
{
namespace
{
struct Lamp {
    int alone;
};

int function() { return 1; }
}

struct Held {
    int outer;
};

enum class Lit { a, b }; // on one line
}
