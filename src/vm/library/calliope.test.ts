import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { linesOf, play } from './testing/play';

const device = { type: calliopeMini3 };
const onCalliope = (program: string): string[] => linesOf(program, {}, undefined, device);
const start = (program: string) => play(program, {}, undefined, device);

describe('the module of the Calliope mini', () => {
  it('is called calliopemini and also answers to microbit', () => {
    const program = `
import calliopemini, microbit
print(calliopemini is microbit, calliopemini.__name__, calliopemini.pin3 is pin3)`;
    expect(onCalliope(program)).toEqual(['True calliopemini True']);
  });

  it('does not exist on the micro:bit', () => {
    const program = `
for name in ('calliopemini', 'calliope_mini'):
    err(__import__, name)
    err(__import__, name)
print(__name__, __import__('microbit').__name__)`;
    expect(linesOf(program)).toEqual([
      "ImportError: no module named 'calliopemini'",
      "ImportError: no module named 'calliopemini'",
      "ImportError: no module named 'calliope_mini'",
      "ImportError: no module named 'calliope_mini'",
      '__main__ microbit',
    ]);
  });

  it('has the pins of its firmware in their classes, and not those of the micro:bit', () => {
    const program = `
print(pin3, pin_A1_RX, pin_A1_TX, pin_A0_SCL, pin_RGB, pin_M0_SPEED, pin_logo)
print([n for n in ('pin16', 'pin17', 'pin19', 'pin20') if n in globals()])
print(pin_A0_SDA.get_mode(), pin18.get_mode(), pin3.get_mode())
err(pin18.write_digital, 1)
err(pin_A0_SCL.read_digital)`;
    expect(onCalliope(program)).toEqual([
      '<MicroBitTouchPin> <MicroBitAnalogDigitalPin> <MicroBitDigitalPin> <MicroBitDigitalPin> <MicroBitDigitalPin> ' +
        '<MicroBitDigitalPin> <MicroBitTouchOnlyPin>',
      '[]',
      'i2c display unused',
      'ValueError: Pin 18 in display mode',
      'ValueError: Pin 19 in i2c mode',
    ]);
  });

  it('tells its firmware', () => {
    const program = `
import os, sys
print(os.uname().machine, os.uname()[2], os.uname().sysname, sys.platform)
print(os.uname().version)
print(sys.implementation, sys.version)`;
    expect(onCalliope(program)).toEqual([
      'Calliope mini with nRF52833 2.1.2b microbit microbit',
      'micro:bit v2.1.2b+5d837a8 on 2024-11-05; MicroPython b7ce7a8 on 2024-11-05',
      "(name='micropython', version=(1, 23, 0, ''), _machine='Calliope mini v2.1.2b with nRF52833') 3.4.0; MicroPython " +
        'b7ce7a8 on 2024-11-05',
    ]);
    expect(linesOf('import os, sys\nprint(os.uname().release, sys.implementation.version)')).toEqual([
      '2.1.2 (1, 18, 0)',
    ]);
  });

  it('counts touches of pin 3 and the logo, which the micro:bit v2.1.2 cannot and the newest can', () => {
    const run = start(`
from calliopemini import *
sleep(400)
print(pin3.is_touched(), pin3.was_touched(), pin3.get_touches(), pin3.get_touches(), pin_logo.was_touched())
pin_logo.touch_calibrate()`);
    const pad = run.bench.board.touch.get('pin3');
    for (const ms of [10, 110]) {
      run.until(ms);
      pad?.press();
      run.until(ms + 50);
      pad?.release();
    }
    expect(run.until(1000).printed()).toBe('False True 2 0 False\n');
    expect(linesOf("print(hasattr(pin0, 'was_touched'), hasattr(pin_logo, 'get_touches'))")).toEqual(['False False']);
    const newest = { firmware: microbitV2.firmwares[1] };
    expect(linesOf("print(pin0.was_touched(), hasattr(pin_logo, 'get_touches'))", {}, undefined, newest)).toEqual([
      'False True',
    ]);
  });

  it('lights its three RGB LEDs as NeoPixels on pin_RGB', () => {
    const run = start(`
from calliopemini import *
import neopixel
np = neopixel.NeoPixel(pin_RGB, 3)
np[0] = (255, 0, 0)
np[2] = (1, 2, 3)
np.show()`);
    expect(run.until(100).bench.board.rgb).toEqual([
      [255, 0, 0],
      [0, 0, 0],
      [1, 2, 3],
    ]);
  });

  it('drives motor 0 forwards with half and motor 1 backwards with full power', () => {
    const run = start(`
from calliopemini import *
pin_M_MODE.write_digital(1)
pin_M0_DIR.write_digital(0)
pin_M0_SPEED.write_analog(512)
pin_M1_DIR.write_digital(1)
pin_M1_SPEED.write_analog(1023)`);
    const duties = run.until(100).bench.board.motors.map((motor) => motor.duty);
    expect(duties[0]).toBe(0.5);
    expect(duties[1]).toBeCloseTo(-1, 2);
  });

  it('reaches chips on its Grove connector A0', () => {
    const lines = linesOf(
      'i2c.init(sda=pin_A0_SDA, scl=pin_A0_SCL)\nprint(i2c.scan())',
      {},
      ({ board }) => {
        board.i2c.attach(0x20, { write: () => undefined, read: () => new Uint8Array(0) });
      },
      device,
    );
    expect(lines).toEqual(['[32]']);
  });
});

describe('programs for the Calliope mini 1 and 2', () => {
  it('import calliope_mini, light the LED and use the pads by their printed names', () => {
    const run = start(`
from calliope_mini import *
led.set_colors(10, 20, 300)
led.set_red(5)
print(led.get_colors(), led.get_blue(), p3 is pin3, c0 is pin0, pin20.get_mode())
import calliope_mini as CM
CM.display.show(CM.Image.HEART)
print(CM.__name__, CM.button_a.is_pressed(), CM.pin1.read_analog() > 900)
CM.sleep(10)
CM.led.clear()`);
    run.until(5);
    expect(run.bench.board.rgb[2]).toEqual([5, 20, 44]);
    expect(run.until(100).printed()).toBe('(5, 20, 44) 44 True True i2c\ncalliope_mini False False\n');
    expect(run.bench.board.rgb[0]).toEqual([0, 0, 0]);
  });

  it('find led only there: the module of the mini 3 has none', () => {
    expect(onCalliope("import calliopemini\nprint(hasattr(calliopemini, 'led'), 'led' in dir())")).toEqual([
      'False False',
    ]);
  });
});
