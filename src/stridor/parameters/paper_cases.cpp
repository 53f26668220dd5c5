#include "stridor/parameters/paper_cases.hpp"

namespace stridor::parameters {

Case paper_case(PaperCase which) {
    Case c;  // the defaults are the table's squeal column
    c.run.step = 1e-7;
    switch (which) {
        case PaperCase::squeal:
            c.title = "squeal: mode coupling while going (Table 1, column 2)";
            break;
        case PaperCase::squeak:
            c.title = "squeak: irregular stick-slip with separation (Table 1, column 3)";
            c.contact().kinetic_friction = 0.2;
            c.contact().preload = 200.0;
            break;
        case PaperCase::creak:
            c.title = "creak: long sticks, short slips under high preload (Table 1, column 4)";
            c.contact().kinetic_friction = 0.2;
            c.contact().preload = 2000.0;
            break;
        case PaperCase::quiet:
            c.title = "no noise: nothing but slip between the reversals (Table 1, column 1)";
            c.contact().kinetic_friction = 0.2;
            break;
    }
    return c;
}

}  // namespace stridor::parameters
