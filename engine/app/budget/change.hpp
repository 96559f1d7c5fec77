// What an option changes of a frame, measured in a small picture and told for a large one: each pass grows with the picture as it does in
// the default frame, and a pass that is declared as it is there takes as long, whatever a clock says.
#pragma once
#include "engine/app/budget/look.hpp"

namespace afterglow
{
struct Change {
    double error = 0.0; // mean relative squared error of the frame
    std::map<std::string, double>
        times;          // passes of the default frame that are declared otherwise: their time over what it is there. 0: gone
    double added = 0.0; // time of passes that are not there, over the whole of the default frame's
};

Change changeOf(const Judged& standing, const Judged& changed);

// What it adds to the large frame, ms.
double addedMs(const Change& change, const Look& small, const Look& large,
               double pixels); // `pixels`: of the large one, over the small one's
}
