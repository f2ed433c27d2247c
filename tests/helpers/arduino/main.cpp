/* Runs a sketch on simulated time. Each line of the input is a period of 20 ms: whether the IMU answers, three
   accelerations and three angular velocities in counts, and the text that arrives on the serial port, or "-". Each line
   of the output: the level of the PCA9685's output enable, and the pulses of its channels, in ticks. */
#include <Arduino.h>
#include <Wire.h>
#include <iostream>
#include <string>

#include "policy.h"

void setup();
void loop();

static uint32_t now;
static int output_enable = -1, imu_answers = 1;
static int16_t counts[7] = {0, 0, 8192, 0, 0, 0, 0};
static std::string typed;
static uint8_t pca[256], sent[64], reply[14];
static size_t written, taken;
static uint8_t target;

StubSerial Serial;
StubWire Wire;

uint32_t micros() { return now; }
void delay(uint32_t milliseconds) { now += 1000 * milliseconds; }
void pinMode(int, int) {}
void digitalWrite(int, int level) { output_enable = level; }
void enableLoopWDT() {}

void StubSerial::begin(unsigned long) {}
int StubSerial::available() { return (int)typed.size(); }
int StubSerial::read()
{
    char c = typed[0];
    typed.erase(0, 1);
    return c;
}
void StubSerial::println(const char *text) { std::cerr << text << "\n"; }

void StubWire::begin() {}
void StubWire::setClock(uint32_t) {}
void StubWire::beginTransmission(uint8_t device)
{
    target = device;
    written = 0;
}
size_t StubWire::write(uint8_t value)
{
    sent[written++] = value;
    return 1;
}
uint8_t StubWire::endTransmission(bool)
{
    if (target == 0x40)
        for (size_t i = 1; i < written; i++)
            pca[(uint8_t)(sent[0] + i - 1)] = sent[i];
    return target == 0x68 && !imu_answers ? 2 : 0;
}
uint8_t StubWire::requestFrom(uint8_t device, uint8_t count)
{
    if (device != 0x68 || !imu_answers)
        return 0;
    for (int i = 0; i < 7; i++) {
        reply[2 * i] = (uint8_t)(counts[i] >> 8);
        reply[2 * i + 1] = (uint8_t)(counts[i] & 0xFF);
    }
    taken = 0;
    return count;
}
int StubWire::read() { return reply[taken++]; }

int main()
{
    setup();
    int a[6];
    std::string text;
    while (std::cin >> imu_answers >> a[0] >> a[1] >> a[2] >> a[3] >> a[4] >> a[5] >> std::ws) {
        std::getline(std::cin, text);
        for (int i = 0; i < 3; i++) {
            counts[i] = (int16_t)a[i];
            counts[4 + i] = (int16_t)a[3 + i];
        }
        if (text != "-")
            typed += text + "\n";
        /* The loop is called far more often than it acts. */
        for (int i = 0; i < 10; i++, now += 2000)
            loop();
        std::cout << output_enable;
        for (int channel = 0; channel < POLICY_JOINTS; channel++) {
            const uint8_t *led = pca + 0x06 + 4 * channel;
            std::cout << " " << (led[2] | led[3] << 8);
        }
        std::cout << "\n";
    }
    return pca[0x00] == 0x20 && pca[0xFE] == 121 ? 0 : 1;
}
