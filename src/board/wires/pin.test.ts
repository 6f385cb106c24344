import { describe, expect, it } from 'vitest';
import { busyMessage } from './pin';
import { createBench } from '../testing/bench';

describe('a digital pin', () => {
  it('G1: the display, the buttons and I2C hold their pins', () => {
    const { board } = createBench();
    const holders = [...board.pins.values()].map((pin) => [pin.name, pin.acquire('write_digital')]);
    expect(Object.fromEntries(holders.filter(([, holder]) => holder !== null))).toEqual({
      pin3: 'display',
      pin4: 'display',
      pin5: 'button',
      pin6: 'display',
      pin7: 'display',
      pin10: 'display',
      pin11: 'button',
      pin19: 'i2c',
      pin20: 'i2c',
    });
  });

  it('G1: a held pin has the words of the device', () => {
    const pin = createBench().board.pin('pin3');
    expect(busyMessage(pin, pin.acquire('read_digital') ?? 'unused')).toBe('Pin 3 in display mode');
    expect(() => pin.readDigital()).toThrow(/Pin 3 in display mode/);
  });

  it('G1: a pin changes freely between reading, writing and touching', () => {
    const pin = createBench().board.pin('pin0');
    for (const mode of ['read_digital', 'write_digital', 'write_analog', 'touch', 'unused'] as const) {
      expect(pin.acquire(mode)).toBeNull();
      expect(pin.mode).toBe(mode);
    }
  });

  it('G2: pin 5 can be read although button A has it, and reads 1 while nobody presses', () => {
    const { board } = createBench();
    const pin = board.pin('pin5');
    expect(pin.readDigital()).toBe(1);
    expect(pin.mode).toBe('button');
    board.buttonA.press();
    expect(pin.readDigital()).toBe(0);
  });

  it('G3: reading lets go of the wire, so a chip can be heard that was drowned before', () => {
    const { board, chip } = createBench();
    const pin = board.pin('pin13');
    chip('P13').drive(1);
    pin.writeDigital(0);
    expect(board.wire('P13').level).toBe(0);
    expect(pin.readDigital()).toBe(1);
    expect(pin.mode).toBe('read_digital');
  });

  it('G4: an input pulls down, until the program pulls up', () => {
    const { board } = createBench();
    const pin = board.pin('pin8');
    expect(pin.readDigital()).toBe(0);
    expect(pin.pull).toBe('down');
    pin.setPull('up');
    expect(pin.readDigital()).toBe(1);
    pin.setPull('none');
    expect(pin.readDigital()).toBe(0);
  });

  it('G4: the chosen pull is there again after the pin has been an output', () => {
    const { board } = createBench();
    const pin = board.pin('pin8');
    pin.setPull('up');
    pin.writeDigital(0);
    pin.free();
    expect(board.wire('P8').level).toBe(0);
    expect(pin.readDigital()).toBe(1);
  });

  it('G5: a pin that is given back drives nothing any more', () => {
    const { board } = createBench();
    const pin = board.pin('pin8');
    pin.writeDigital(1);
    pin.free();
    expect(board.wire('P8').level).toBe(0);
    pin.writeAnalog(512);
    pin.free();
    expect(board.wire('P8').pwm).toBeNull();
    expect(pin.mode).toBe('unused');
  });
});

describe('an analog pin', () => {
  it('A1: reads half the supply as 512 and the supply as 1023', () => {
    const { board, chip } = createBench();
    const pin = board.pin('pin1');
    const sensor = chip('P1');
    const readings = [0, 0.25, 0.5, 1].map((fraction) => {
      sensor.driveAnalog(fraction);
      return pin.readAnalog();
    });
    expect(readings).toEqual([0, 256, 512, 1023]);
  });

  it('A1: gets back every value from 0 to 1023 that a chip puts on the wire', () => {
    const { board, chip } = createBench();
    const pin = board.pin('pin1');
    const sensor = chip('P1');
    for (let value = 0; value <= 1023; value++) {
      sensor.driveAnalog(value / 1023);
      expect(pin.readAnalog()).toBe(value);
    }
  });

  it('A1: measures a PWM signal as its mean', () => {
    const { board, chip } = createBench();
    chip('P1').drivePwm({ periodUs: 1000, dutyFraction: 0.5 });
    expect(board.pin('pin1').readAnalog()).toBe(512);
  });

  it('A2: reads 512 with nothing connected, also when it was pulled up as a digital input before', () => {
    const { board, chip } = createBench();
    const pin = board.pin('pin1');
    pin.setPull('up');
    expect(pin.readAnalog()).toBe(512);
    expect(pin.readDigital()).toBe(1); // the pull that it chose
    chip('P1').pull('down');
    expect(pin.readAnalog()).toBe(0);
    expect(pin.mode).toBe('unused');
  });

  it('A3: writes 0 to 1023 and nothing else', () => {
    const pin = createBench().board.pin('pin1');
    pin.writeAnalog(1023);
    expect(() => pin.writeAnalog(1024)).toThrow('Analog value 1024 is not within 0 … 1023.');
    expect(() => pin.writeAnalog(-1)).toThrow(RangeError);
    expect(() => pin.writeAnalog(NaN)).toThrow(RangeError);
  });
});

describe('PWM', () => {
  it('P1: 512 is high for 10 of 20 ms, 77 for 1504 µs (a servo in its middle)', () => {
    const { board } = createBench();
    const pin = board.pin('pin0');
    pin.writeAnalog(512);
    expect(board.wire('P0').pwm).toEqual({ periodUs: 20_000, dutyFraction: 0.5 });
    pin.writeAnalog(77);
    expect((board.wire('P0').pwm?.dutyFraction ?? 0) * 20_000).toBeCloseTo(1504, 6);
  });

  it('P1: 1023 is not quite always high', () => {
    const { board } = createBench();
    board.pin('pin0').writeAnalog(1023);
    expect(board.wire('P0').fraction).toBeCloseTo(1023 / 1024, 4);
    expect(board.wire('P0').level).toBe(1);
  });

  it('P2: a new period changes the signals of all pins and keeps their shares', () => {
    const { board, record } = createBench();
    board.pin('pin0').writeAnalog(512);
    board.pin('pin1').writeAnalog(256);
    const happened = record('P0');
    expect(board.pin('pin1').setAnalogPeriodUs(1000)).toBe(true);
    expect(happened).toEqual(['0 ms: 500 of 1000 µs high']);
    expect(board.wire('P1').pwm).toEqual({ periodUs: 1000, dutyFraction: 0.25 });
    expect(board.pin('pin0').analogPeriodUs).toBe(1000);
  });

  it('P3: the period may be 1 to 262143 µs, and nothing changes for any other', () => {
    const pin = createBench().board.pin('pin0');
    pin.writeAnalog(1);
    expect([1, 262_143].map((us) => pin.setAnalogPeriodUs(us))).toEqual([true, true]);
    pin.setAnalogPeriodUs(5000);
    expect([0, -5, 262_144, NaN, Infinity].map((us) => pin.setAnalogPeriodUs(us))).toEqual(Array(5).fill(false));
    expect(pin.analogPeriodUs).toBe(5000);
  });

  it('P3: 100,001 µs come out as 100,000, for the counter has only 15 bits', () => {
    const pin = createBench().board.pin('pin0');
    pin.setAnalogPeriodUs(100_001);
    expect(pin.analogPeriodUs).toBe(100_000);
  });

  it('P4: a fifth pin takes the channel of the first, which goes low', () => {
    const { board } = createBench();
    for (const name of ['pin0', 'pin1', 'pin2', 'pin8']) board.pin(name).writeAnalog(512);
    expect(board.wire('P0').pwm?.dutyFraction).toBe(0.5);
    board.pin('pin12').writeAnalog(256);
    expect(board.wire('P12').pwm?.dutyFraction).toBe(0.25);
    expect(board.wire('P0').pwm).toBeNull();
    expect(board.wire('P0').level).toBe(0);
    board.pin('pin0').setAnalogPeriodUs(1000);
    expect(board.wire('P0').pwm).toBeNull();
    board.pin('pin0').writeAnalog(512);
    expect(board.wire('P0').pwm?.dutyFraction).toBe(0.5);
    expect(board.wire('P1').pwm).toBeNull();
  });

  it('P5: writing 0 is a steady low and leaves the pin unused', () => {
    const { board, record } = createBench();
    const pin = board.pin('pin0');
    pin.writeAnalog(900);
    expect(pin.mode).toBe('write_analog');
    const happened = record('P0');
    pin.writeAnalog(0);
    expect(happened).toEqual(['0 ms: 0', '0 ms: no PWM']);
    expect(pin.mode).toBe('unused');
  });

  it('P6: a digital write ends the signal, and a new period does not bring it back', () => {
    const { board } = createBench();
    const pin = board.pin('pin0');
    pin.writeAnalog(512);
    pin.writeDigital(1);
    expect(board.wire('P0').pwm).toBeNull();
    board.pin('pin1').setAnalogPeriodUs(1000);
    expect(board.wire('P0').pwm).toBeNull();
    expect(board.wire('P0').level).toBe(1);
  });

  it('P7: a pin that is no analog output has the period -1', () => {
    const pin = createBench().board.pin('pin0');
    expect(pin.analogPeriodUs).toBe(-1);
    pin.writeAnalog(5);
    expect(pin.analogPeriodUs).toBe(20_000);
    pin.readDigital();
    expect(pin.analogPeriodUs).toBe(-1);
  });

  it('P8: setting the period of a free pin makes it an output at 0, a held pin is left alone', () => {
    const { board, chip } = createBench();
    chip('P8').drive(1);
    expect(board.pin('pin8').setAnalogPeriodUs(3000)).toBe(true);
    expect(board.wire('P8').level).toBe(0);
    expect(board.pin('pin8').analogPeriodUs).toBe(3000);
    expect(board.pin('pin3').setAnalogPeriodUs(4000)).toBe(true);
    expect(board.pin('pin3').mode).toBe('display');
    expect(board.pin('pin3').analogPeriodUs).toBe(-1);
  });

  it('P9: after writing 0 the pin still has its period of 20 ms', () => {
    const pin = createBench().board.pin('pin0');
    pin.writeAnalog(0);
    expect([pin.mode, pin.analogPeriodUs]).toEqual(['unused', 20_000]);
  });
});

describe('a pin that others use', () => {
  it('G6: get_pull tells up until a resistor is chosen, although the input pulls down', () => {
    const { board } = createBench();
    const pin = board.pin('pin0');
    expect([pin.readDigital(), pin.reportedPull]).toEqual([0, 'up']);
    pin.setPull('none');
    expect(pin.reportedPull).toBe('none');
  });

  it('G7: a tone leaves a pin alone that the display holds, and display.off() twice ends the music on its pin', () => {
    const { board } = createBench();
    board.pin('pin3').playTone(1000);
    expect(board.wire('P3').pwm).toBeNull();
    board.display.off();
    board.music.play(['c4:4', 'd4:4', 'e4:4', 'f4:4'], { pin: board.pin('pin3'), loop: true });
    board.clock.advanceTo(100_000);
    expect(board.wire('P3').pwm?.periodUs).toBe(3822);
    board.display.off();
    board.clock.advanceTo(600_000);
    expect(board.wire('P3').pwm).toBeNull();
    expect(board.display.on()).toBeNull();
    board.clock.advanceTo(2_000_000);
    board.music.stop();
    expect(board.pin('pin3').mode).toBe('display');
  });
});
