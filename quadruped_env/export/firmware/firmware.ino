/* A walking robot's control loop on an ESP32: hobby servos on a PCA9685, an MPU-6050, velocity commands on the serial
   port. It has never run on hardware: a test compiles it for a PC and runs it with simulated devices.

   Wiring: I2C to both boards; the PCA9685's OE to OE_PIN, with 10 kOhm from OE to 3.3 V. Without the ESP32's low level
   the servos are off, also while it is reset: the PCA9685 alone would send its last pulses for ever.

   Serial, 115200 baud, one line per command: "0.3 0.5" walks at 0.3 m/s and turns at 0.5 rad/s, "x" switches the servos
   off. The first command makes the robot stand up: put its legs in the stance by hand before. */

#include <Arduino.h>
#include <Wire.h>
#include <math.h>
#include <stdio.h>

#include "policy.h"

/* Your robot. Pulse of a joint at an angle: zero_us + sign * US_PER_RAD * angle. Find sign and zero with one servo at a
   time, without its horn, and without power on the others. */
struct Servo {
    uint8_t channel;
    float sign;
    float zero_us;
};
static const Servo SERVOS[POLICY_JOINTS] = {
    /* one line per joint */
};
static const float US_PER_RAD = 636.6f; /* 500 to 2500 us for 180 degrees */
static const float SERVO_SPEED = 5.0f;  /* rad/s, of the servo under load */
static const int OE_PIN = 4;

static const uint8_t PCA9685 = 0x40, MPU6050 = 0x68;
static const float GYRO = 3.14159265f / 180.0f / 65.5f; /* rad/s per count, at +-500 deg/s */
static const float ATTITUDE_TIME = 0.5f;                /* s in which the attitude follows the accelerometer */
static const float UPRIGHT = 0.3f, UPRIGHT_FOR = 1.0f;  /* it stands up after a second below this tilt: rad, s */

static enum { LIMP, STANDING_UP, WALKING } state = LIMP;
static policy_memory memory;
static policy_readings readings;
static float gravity[3] = {0.0f, 0.0f, -1.0f}, rate[3], gyro_zero[3];
static float sent[POLICY_JOINTS], servo[POLICY_JOINTS]; /* joint targets, and where the servos are by now, rad */
static float requested[POLICY_COMMANDS];
static float since_command = INFINITY, since_reading, since_target, upright, settled; /* s */
static bool stop_asked;

static void write_register(uint8_t device, uint8_t address, uint8_t value)
{
    Wire.beginTransmission(device);
    Wire.write(address);
    Wire.write(value);
    Wire.endTransmission();
}

/* Acceleration in g, as counts / 8192, and angular velocity in counts; false if the IMU does not answer. */
static bool read_imu(float acceleration[3], float angular_velocity[3])
{
    Wire.beginTransmission(MPU6050);
    Wire.write(0x3B);
    if (Wire.endTransmission(false) != 0 || Wire.requestFrom(MPU6050, (uint8_t)14) != 14)
        return false;
    int16_t counts[7];
    for (int i = 0; i < 7; i++) {
        int high = Wire.read(), low = Wire.read();
        counts[i] = (int16_t)(high << 8 | low);
    }
    /* The IMU's x is forward and its z up; swap and negate here if it is mounted differently. */
    for (int i = 0; i < 3; i++) {
        acceleration[i] = counts[i] / 8192.0f;
        angular_velocity[i] = counts[4 + i];
    }
    return true;
}

/* Direction of gravity in the base frame: turned by the gyroscope, and drawn to the accelerometer's slowly. */
static bool read_attitude()
{
    float f[3], w[3];
    if (!read_imu(f, w))
        return false;
    for (int i = 0; i < 3; i++)
        rate[i] = GYRO * (w[i] - gyro_zero[i]);
    float size = sqrtf(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]), length = 0.0f, next[3];
    float share = fabsf(size - 1.0f) < 0.3f ? POLICY_TIMESTEP / ATTITUDE_TIME : 0.0f;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        next[i] = gravity[i] + POLICY_TIMESTEP * (gravity[j] * rate[k] - gravity[k] * rate[j]);
        if (share > 0.0f)
            next[i] += share * (-f[i] / size - next[i]);
        length += next[i] * next[i];
    }
    for (int i = 0; i < 3; i++)
        gravity[i] = next[i] / sqrtf(length);
    return true;
}

/* Hobby servos report nothing. These are the positions that they should have; with encoders, read those instead. A
   policy that observes no joints does not need them. */
static void read_joints()
{
    float before[POLICY_JOINTS];
    for (int j = 0; j < POLICY_JOINTS; j++)
        before[j] = servo[j];
    policy_approach(sent, SERVO_SPEED, servo);
    for (int j = 0; j < POLICY_JOINTS; j++) {
#ifdef POLICY_READS_JOINT_POSITION
        readings.joint_position[j] = servo[j];
#endif
#ifdef POLICY_READS_JOINT_VELOCITY
        readings.joint_velocity[j] = (servo[j] - before[j]) / POLICY_TIMESTEP;
#endif
    }
}

/* False if a reading is missing: fields of your own are NaN until you fill them here. */
static bool fill_readings()
{
    float *every = (float *)&readings;
    for (size_t i = 0; i < sizeof readings / sizeof *every; i++)
        every[i] = NAN;
    for (int i = 0; i < 3; i++) {
#ifdef POLICY_READS_PROJECTED_GRAVITY
        readings.projected_gravity[i] = gravity[i];
#endif
#ifdef POLICY_READS_ANGULAR_VELOCITY
        readings.angular_velocity[i] = rate[i];
#endif
    }
    read_joints();
    for (size_t i = 0; i < sizeof readings / sizeof *every; i++)
        if (isnan(every[i]))
            return false;
    return true;
}

static void write_servos()
{
    for (int j = 0; j < POLICY_JOINTS; j++) {
        float us = SERVOS[j].zero_us + SERVOS[j].sign * US_PER_RAD * sent[j];
        us = us < 500.0f ? 500.0f : us > 2500.0f ? 2500.0f : us;
        uint16_t ticks = (uint16_t)(us * (4096.0f / 20000.0f) + 0.5f);
        Wire.beginTransmission(PCA9685);
        Wire.write((uint8_t)(0x06 + 4 * SERVOS[j].channel));
        Wire.write((uint8_t)0);
        Wire.write((uint8_t)0);
        Wire.write((uint8_t)(ticks & 0xFF));
        Wire.write((uint8_t)(ticks >> 8));
        Wire.endTransmission();
    }
    digitalWrite(OE_PIN, LOW);
}

static void go_limp(const char *why)
{
    static const char *said = "";
    digitalWrite(OE_PIN, HIGH);
    if (state != LIMP || said != why)
        Serial.println(said = why);
    state = LIMP;
    since_command = INFINITY; /* stand up at the next command */
}

static void read_commands()
{
    static char line[32];
    static size_t length = 0;
    while (Serial.available() > 0) {
        char c = (char)Serial.read();
        if (c != '\n' && c != '\r') {
            if (length < sizeof line - 1)
                line[length++] = c;
            continue;
        }
        line[length] = '\0';
        if (length > 0) {
            /* read velocities */
            since_command = stop_asked ? INFINITY : 0.0f;
        }
        length = 0;
    }
}

void setup()
{
    pinMode(OE_PIN, OUTPUT);
    digitalWrite(OE_PIN, HIGH);
    Serial.begin(115200);
    Wire.begin();
    Wire.setClock(400000);
    write_register(PCA9685, 0x00, 0x10); /* sleep, to set the frequency: 25 MHz / 4096 / (121 + 1) = 50 Hz */
    write_register(PCA9685, 0xFE, 121);
    write_register(PCA9685, 0x00, 0x20); /* awake, registers one after another */
    write_register(MPU6050, 0x6B, 0x00); /* awake */
    write_register(MPU6050, 0x1A, 0x03); /* low pass of 44 Hz */
    write_register(MPU6050, 0x1B, 0x08); /* +-500 deg/s */
    write_register(MPU6050, 0x1C, 0x08); /* +-4 g */
    delay(100);
    /* The gyroscope's zero: the robot lies still for half a second. */
    int counted = 0;
    float acceleration[3], counts[3], sum[3] = {0.0f, 0.0f, 0.0f};
    for (int n = 0; n < 100; n++, delay(5))
        if (read_imu(acceleration, counts)) {
            counted++;
            for (int i = 0; i < 3; i++)
                sum[i] += counts[i];
        }
    for (int i = 0; i < 3; i++)
        gyro_zero[i] = counted > 0 ? sum[i] / (float)counted : 0.0f;
    for (int j = 0; j < POLICY_JOINTS; j++)
        sent[j] = servo[j] = policy_stance[j];
    enableLoopWDT(); /* resets the ESP32, and so switches the servos off, if the loop hangs */
    Serial.println(POLICY_NAME " for " POLICY_ROBOT ": waits for a command");
}

void loop()
{
    static const uint32_t STEP = (uint32_t)(1e6f * POLICY_TIMESTEP + 0.5f);
    static uint32_t due = micros();
    uint32_t late = micros() - due;
    if ((int32_t)late < 0)
        return;
    due += late < STEP ? STEP : late + STEP; /* after a pause, steps are not made up for */

    read_commands();
    bool fresh = read_attitude();
    fresh = fill_readings() && fresh;
    since_reading = fresh ? 0.0f : since_reading + POLICY_TIMESTEP;
    since_command += POLICY_TIMESTEP;
    float tilt = acosf(fmaxf(-1.0f, fminf(1.0f, -gravity[2])));
    upright = fresh && tilt < UPRIGHT ? upright + POLICY_TIMESTEP : 0.0f;

    if (stop_asked)
        go_limp("limp: asked to stop");
    else if (tilt > POLICY_MAX_TILT)
        go_limp("limp: fallen");
    else if (since_reading > POLICY_LIMP_AFTER)
        go_limp("limp: no readings");
    else if (since_target > POLICY_INVALID_AFTER)
        go_limp("limp: no valid joint targets");
    else if (state == LIMP && upright > UPRIGHT_FOR && since_command < POLICY_COMMAND_TIMEOUT) {
        state = STANDING_UP;
        settled = since_target = 0.0f;
        for (int j = 0; j < POLICY_JOINTS; j++)
            sent[j] = servo[j];
    }
    if (state == LIMP)
        return;

    if (state == STANDING_UP) {
        settled = policy_approach(policy_stance, POLICY_RAMP_SPEED, sent) ? settled + POLICY_TIMESTEP : 0.0f;
        if (settled > POLICY_SETTLE) {
            policy_reset(&memory);
            state = WALKING;
        }
    } else if (fresh) {
        float target[POLICY_JOINTS];
        float standing[POLICY_COMMANDS] = {0.0f};
        since_target += POLICY_TIMESTEP;
        if (policy_step(&readings, since_command < POLICY_COMMAND_TIMEOUT ? requested : standing, &memory, target)) {
            policy_approach(target, INFINITY, sent);
            since_target = 0.0f;
        }
    }
    write_servos(); /* without fresh readings or valid targets: the same targets again */
}
