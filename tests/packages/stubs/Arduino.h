// What a sketch gets without asking: the macros of Arduino's cores, and a serial port.
#pragma once

#include <math.h>
#include <stdint.h>

#define PI 3.1415926535897932384626433832795
#define HALF_PI 1.5707963267948966192313216916398
#define TWO_PI 6.283185307179586476925286766559
#define DEG_TO_RAD 0.017453292519943295769236907684886
#define HIGH 0x1
#define LOW 0x0
#define INPUT 0x0
#define OUTPUT 0x1
#define SERIAL 0x0
#define DISPLAY 0x1
#define DEFAULT 1
#define EXTERNAL 0
#define B1 1
#define B0 0
#define F(text) (text)
#define SS 10
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x) ((x) > 0 ? (x) : -(x))
#define constrain(x, low, high) ((x) < (low) ? (low) : ((x) > (high) ? (high) : (x)))
#define radians(deg) ((deg)*DEG_TO_RAD)
#define degrees(rad) ((rad) / DEG_TO_RAD)
#define sq(x) ((x) * (x))
#define bit(b) (1UL << (b))
#define lowByte(w) ((uint8_t)((w)&0xff))
#define highByte(w) ((uint8_t)((w) >> 8))
#define interrupts()
#define noInterrupts()

extern "C" unsigned long millis(void);
extern "C" void delay(unsigned long);
struct SerialPort {
  void begin(unsigned long) {}
  template <class... T>
  void print(const T&...) {}
  template <class... T>
  void println(const T&...) {}
};
inline SerialPort Serial;
