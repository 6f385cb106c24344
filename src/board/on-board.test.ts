import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from './boards/calliope-mini-3';
import { createBench } from './testing/bench';

describe('the RGB LEDs of the Calliope mini', () => {
  it('L1: are three and dark after a start; the micro:bit has none', () => {
    expect(createBench(calliopeMini3).board.rgb).toEqual([
      [0, 0, 0],
      [0, 0, 0],
      [0, 0, 0],
    ]);
    expect(createBench().board.rgb).toEqual([]);
  });

  it('L2: take the bytes as green, red, blue', () => {
    const { board } = createBench(calliopeMini3);
    board.pin('pin_RGB').sendStream(Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12));
    expect(board.rgb).toEqual([
      [2, 1, 3],
      [5, 4, 6],
      [8, 7, 9],
    ]);
  });

  it('L3: a stream that is too short leaves the rest as it was', () => {
    const { board } = createBench(calliopeMini3);
    board.pin('pin_RGB').sendStream(new Uint8Array(9).fill(7));
    board.pin('pin_RGB').sendStream(Uint8Array.of(1, 2, 3, 4, 5));
    expect(board.rgb).toEqual([
      [2, 1, 3],
      [7, 7, 7],
      [7, 7, 7],
    ]);
  });

  it('L4: do not see what is sent on another pin', () => {
    const { board } = createBench(calliopeMini3);
    board.pin('pin0').sendStream(new Uint8Array(9).fill(7));
    expect(board.rgb[0]).toEqual([0, 0, 0]);
  });
});

describe('the motor connectors of the Calliope mini', () => {
  const motors = () => {
    const { board } = createBench(calliopeMini3);
    const write = (name: string, level: 0 | 1): void => board.pin(name).writeDigital(level);
    return { board, write, duties: () => board.motors.map((motor) => motor.duty) };
  };

  it('O1: stand still after a start; the micro:bit has none', () => {
    expect(motors().board.motors).toEqual([
      { name: 'M0', duty: 0 },
      { name: 'M1', duty: 0 },
    ]);
    expect(createBench().board.motors).toEqual([]);
  });

  it('O2: with the mode pin high, direction 0 is forwards at the share of the speed pin, 1 is backwards', () => {
    const { board, write, duties } = motors();
    write('pin_M_MODE', 1);
    write('pin_M0_DIR', 0);
    board.pin('pin_M0_SPEED').writeAnalog(512);
    write('pin_M1_DIR', 1);
    write('pin_M1_SPEED', 1);
    expect(duties()).toEqual([0.5, -1]);
    board.pin('pin_M0_SPEED').writeAnalog(0);
    expect(duties()).toEqual([0, -1]);
  });

  it('O3: with the mode pin low, the one of the two pins that is high turns the motor, both together brake it', () => {
    const { board, write, duties } = motors();
    write('pin_M0_DIR', 1);
    write('pin_M1_SPEED', 1);
    expect(duties()).toEqual([1, -1]);
    write('pin_M1_DIR', 1);
    board.pin('pin_M0_DIR').writeAnalog(256);
    expect(duties()).toEqual([0.25, 0]);
  });
});

describe('a reset of the board', () => {
  it('Z1: frees every pin and forgets modes, pulls and signals', () => {
    const { board } = createBench();
    board.pin('pin0').writeAnalog(512);
    board.pin('pin1').setPull('up');
    board.pin('pin2').writeDigital(1);
    board.display.off();
    board.pin('pin3').writeDigital(1);
    board.reset();
    expect(['pin0', 'pin1', 'pin2', 'pin3', 'pin19'].map((name) => board.pin(name).mode)).toEqual([
      'unused',
      'unused',
      'unused',
      'display',
      'i2c',
    ]);
    expect(['P0', 'P1', 'P2', 'P3'].map((name) => board.wire(name).level)).toEqual([0, 0, 0, 0]);
    expect(board.wire('P0').pwm).toBeNull();
    expect(board.pin('pin1').pull).toBe('down');
  });

  it('Z2: gives back the PWM period of 20 ms and all four channels', () => {
    const { board } = createBench();
    for (const name of ['pin0', 'pin1', 'pin2', 'pin8']) board.pin(name).writeAnalog(100);
    board.pin('pin0').setAnalogPeriodUs(1000);
    board.reset();
    for (const name of ['pin9', 'pin12', 'pin13', 'pin14']) board.pin(name).writeAnalog(512);
    expect(board.wire('P9').pwm).toEqual({ periodUs: 20_000, dutyFraction: 0.5 });
  });

  it('Z3: darkens the display, switches it on and upright again, and ends what moved on it', () => {
    const { board, passMs } = createBench();
    board.display.scroll('long text', { delayMs: 150, loop: true, monospace: false });
    board.display.rotate(1);
    passMs(1000);
    board.display.off();
    board.reset();
    passMs(1000);
    expect(board.display.isOn).toBe(true);
    expect(board.display.isAnimating).toBe(false);
    expect(board.display.pixels).toEqual(new Uint8Array(25));
  });

  it('Z4: ends music and sets its tempo back, the I2C clock to 100 kHz, SPI off, serial to USB at 115200 baud', () => {
    const { board } = createBench();
    board.music.setTempo({ bpm: 60 });
    board.music.pitch(440, -1, board.pin('pin0'));
    board.i2c.setFrequency(400_000);
    board.i2c.useWires({ scl: board.wire('P1'), sda: board.wire('P2') });
    board.spi.init({ clock: board.pin('pin13'), mosi: board.pin('pin15'), miso: board.pin('pin14') }, 8e6, 0);
    board.uart.init(9600, { tx: board.pin('pin8'), rx: board.pin('pin9') });
    board.i2c.attach(0x10, { write: () => undefined, read: () => new Uint8Array(0) });
    board.reset();
    expect([board.music.frequencyHz, board.music.tempo.bpm, board.i2c.frequencyHz]).toEqual([null, 120, 100_000]);
    expect([board.i2c.answers(0x10), board.spi.isOn, board.uart.pins.tx, board.uart.baud]).toEqual([
      true,
      false,
      null,
      115_200,
    ]);
  });

  it('Z5: forgets presses and touches, but a finger that stays is felt again after 36 ms', () => {
    const { board, passMs } = createBench();
    board.buttonA.press();
    board.buttonB.press();
    passMs(100);
    board.buttonB.release();
    passMs(100);
    board.reset();
    expect([board.buttonA.isPressed(), board.buttonB.wasPressed(), board.buttonA.isDown]).toEqual([false, false, true]);
    passMs(40);
    expect([board.buttonA.isPressed(), board.buttonA.takePresses()]).toEqual([true, 1]);
  });

  it('Z6: leaves what is outside: chips on wires and buses, and what the sensors feel', () => {
    const { board, chip } = createBench();
    chip('P8').drive(1);
    board.sensors.set('lightLevel', 10);
    board.i2c.attach(0x20, { write: () => undefined, read: () => new Uint8Array(0) });
    board.reset();
    expect([board.wire('P8').level, board.sensors.get('lightLevel'), board.i2c.answers(0x20)]).toEqual([1, 10, true]);
  });

  it('Z7: leaves the RGB LEDs dark and the motors still', () => {
    const { board } = createBench(calliopeMini3);
    board.pin('pin_RGB').sendStream(new Uint8Array(9).fill(7));
    board.pin('pin_M_MODE').writeDigital(1);
    board.pin('pin_M0_SPEED').writeDigital(1);
    board.reset();
    expect([board.rgb[2], board.motors[0]?.duty]).toEqual([[0, 0, 0], 0]);
  });
});
