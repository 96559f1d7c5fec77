namespace afterglow
{
namespace
{
struct Lamp {
    int alone;
};

int function() { return 1; }
}

static const int kNumbers[] = {1, 2};

struct Held {
    int outer;
};

class Mirror
{
};

enum class Lit { a, b }; // on one line
}
