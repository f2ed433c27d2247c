/* Stub of Arduino's I2C bus, with a PCA9685 and an MPU-6050 on it. */
#pragma once
#include <stddef.h>
#include <stdint.h>

struct StubWire {
    void begin();
    void setClock(uint32_t frequency);
    void beginTransmission(uint8_t device);
    size_t write(uint8_t value);
    uint8_t endTransmission(bool stop = true);
    uint8_t requestFrom(uint8_t device, uint8_t count);
    int read();
};
extern StubWire Wire;
