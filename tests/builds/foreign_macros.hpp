// Macros that other people's headers define, as they define them, for a header that is included behind them.
// Sources: Arduino.h and binary.h of the AVR and SAM cores, avr-libc's sfr_defs.h, newlib's ctype.h, CMSIS and ST's
// device headers, windows.h with windef.h and wingdi.h, C's complex.h and math.h, glibc's sys/sysmacros.h, termios.h.
#pragma once

// Arduino
#define PI 3.1415926535897932384626433832795
#define HALF_PI 1.5707963267948966192313216916398
#define TWO_PI 6.283185307179586476925286766559
#define DEG_TO_RAD 0.017453292519943295769236907684886
#define RAD_TO_DEG 57.295779513082320876798154814105
#define EULER 2.718281828459045235360287471352
#define HIGH 0x1
#define LOW 0x0
#define INPUT 0x0
#define OUTPUT 0x1
#define INPUT_PULLUP 0x2
#define SERIAL 0x0
#define DISPLAY 0x1
#define LSBFIRST 0
#define MSBFIRST 1
#define CHANGE 1
#define FALLING 2
#define RISING 3
#define DEFAULT 1
#define EXTERNAL 0
#define INTERNAL 3
#define min(a, b) ((a) < (b) ? (a) : (b))
#define max(a, b) ((a) > (b) ? (a) : (b))
#define abs(x) ((x) > 0 ? (x) : -(x))
#define constrain(amt, low, high) ((amt) < (low) ? (low) : ((amt) > (high) ? (high) : (amt)))
#define round(x) ((x) >= 0 ? (long)((x) + 0.5) : (long)((x)-0.5))
#define radians(deg) ((deg)*DEG_TO_RAD)
#define degrees(rad) ((rad)*RAD_TO_DEG)
#define sq(x) ((x) * (x))
#define interrupts() sei()
#define noInterrupts() cli()
#define lowByte(w) ((unsigned char)((w)&0xff))
#define highByte(w) ((unsigned char)((w) >> 8))
#define bitRead(value, bit) (((value) >> (bit)) & 0x01)
#define bitSet(value, bit) ((value) |= (1UL << (bit)))
#define bitClear(value, bit) ((value) &= ~(1UL << (bit)))
#define bit(b) (1UL << (b))
#define F(string_literal) (string_literal)
#define PSTR(s) (s)
#define word(...) makeWord(__VA_ARGS__)
#define _BV(bit) (1 << (bit))
#define B0 0
#define B1 1
#define B10 2
#define B11 3
#define B100 4
#define SS 10
#define MOSI 11
#define MISO 12
#define SCK 13
#define SDA 18
#define SCL 19
#define A0 14
#define A1 15
#define A2 16
#define A3 17
#define A4 18
#define A5 19
#define D0 0
#define D1 1
#define SP 0x3D
#define NOT_A_PIN 0
#define ARDUINO 10819
#define Serial1 Serial

// newlib's ctype.h
#define _U 01
#define _L 02
#define _N 04
#define _S 010
#define _P 020
#define _C 040
#define _X 0100
#define _B 0200

// CMSIS, ST
#define __I volatile const
#define __O volatile
#define __IO volatile
#define READ_BIT(REG, BIT) ((REG) & (BIT))
#define SET_BIT(REG, BIT) ((REG) |= (BIT))
#define UNUSED(X) (void)X
#define RCC ((void*)0x40023800)
#define PWR ((void*)0x40007000)
#define FLASH ((void*)0x40023C00)
#define ADC ((void*)0x40012300)
#define I2C1 ((void*)0x40005400)
#define CRC ((void*)0x40023000)
#define RNG ((void*)0x50060800)
#define SET 1
#define RESET 0
#define ENABLE 1
#define DISABLE 0
#define ERROR 1
#define SUCCESS 0
#define OVERFLOW 3
#define UNDERFLOW 4
#define DOMAIN 1
#define SING 2

// Windows
#define near
#define far
#define NEAR
#define FAR
#define small char
#define hyper long long
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define CONST const
#define VOID void
#define TRUE 1
#define FALSE 0
#define DELETE 0x00010000L
#define NO_ERROR 0L
#define ABSOLUTE 1
#define RELATIVE 2
#define OPAQUE 2
#define TRANSPARENT 1
#define GetObject GetObjectA
#define GetMessage GetMessageA
#define SendMessage SendMessageA
#define CreateWindow CreateWindowA
#define DrawText DrawTextA
#define pascal
#define cdecl
#define rad1 0x0420
#define STRICT 1
#define DIFFERENCE 11
#define grp1 0x0430

// C's complex.h, termios.h, sysmacros.h, and what a GNU dialect defines
#define complex _Complex
#define imaginary _Imaginary
#define huge
#define major(dev) gnu_dev_major(dev)
#define minor(dev) gnu_dev_minor(dev)
#define makedev(maj, min) gnu_dev_makedev(maj, min)
#define B50 1
#define CR0 0
#define NL0 0
#define ECHO 010
#define unix 1
#define linux 1
