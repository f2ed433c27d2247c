/* Stubs of what the sketch uses of Arduino's core for the ESP32. */
#pragma once
#include <stddef.h>
#include <stdint.h>

enum { LOW, HIGH, OUTPUT };

uint32_t micros();
void delay(uint32_t milliseconds);
void pinMode(int pin, int mode);
void digitalWrite(int pin, int level);
void enableLoopWDT();

struct StubSerial {
    void begin(unsigned long baud);
    int available();
    int read();
    void println(const char *text);
};
extern StubSerial Serial;
