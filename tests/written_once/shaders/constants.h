const float kPi = 3.14159265f;
