namespace afterglow
{
struct Lit { // of a frame
    int radiance;
};

class Lamp
{
    struct Held {
        int inner;
    };
};

class Mirror : public Lamp
{
};
}
