import { describe, expect, it } from 'vitest';
import { play } from './testing/play';

const VALUES = `[None, True, 0, -1, 5, 10**6, 2**31, 10**12, 0.5, -1.5, 1e300, float('inf'), float('nan'), '', 'a', 'hello', b'',
    b'abc', [], [1], (1, 2), {}, print, pin0, pin3, Image.HEART, Image('12:3'), display, Image, bytearray(3), range(3), object()]`;

/** Calls of the device's modules that get each of the values in place of `a`. */
const CALLS: Readonly<Record<string, readonly string[]>> = {
  pins: [
    'pin0.write_digital(a)',
    'pin0.write_analog(a)',
    'pin0.set_pull(a)',
    'pin0.set_analog_period(a)',
    'pin1.set_touch_mode(a)',
    'ws2812_write(a, b"1")',
    'ws2812_write(pin0, a)',
    'machine.time_pulse_us(a, 1, 10)',
    'machine.time_pulse_us(pin0, a, 10)',
  ],
  display: [
    'display.show(a, wait=False)',
    'display.show("ab", a, wait=False)',
    'display.show([a], wait=False)',
    'display.show("ab", loop=a, clear=a, wait=False)',
    'display.scroll(a, wait=False)',
    'display.scroll("a", a, wait=False)',
    'display.set_pixel(a, 0, 1)',
    'display.set_pixel(0, 0, a)',
    'display.get_pixel(a, a)',
  ],
  images: [
    'Image(a)',
    'Image(a, 2)',
    'Image(2, 2, a)',
    'Image().set_pixel(a, 0, 0)',
    'Image().fill(a)',
    'Image().shift_left(a)',
    'Image().crop(a, 0, 2, 2)',
    'Image().blit(a, 0, 0, 1, 1)',
    'Image() * a',
    'Image() + a',
  ],
  buses: [
    'i2c.write(a, b"1")',
    'i2c.write(0x10, a)',
    'i2c.read(a, 1)',
    'i2c.read(0x10, a)',
    'i2c.init(a)',
    'uart.init(a)',
    'uart.write(a)',
    'uart.read(a)',
    'uart.readinto(a)',
  ],
  music: [
    'music.pitch(a, 10)',
    'music.pitch(440, a, wait=False)',
    'music.pitch(440, 10, a)',
    'music.play(a, wait=False)',
    'music.set_tempo(bpm=a)',
    'music.play("c:1", wait=False)',
    'music.stop(a)',
  ],
  files: ['os.size(a)', 'os.remove(a)', 'open(a)', 'open("q", a)', 'open("q", "w").write(a)', 'open("q").read(a)'],
  rest: [
    'scale(a, (0, 1), (0, 2))',
    'set_volume(a)',
    'time.ticks_add(a, 1)',
    '__import__(a)',
    'sys.print_exception(a)',
  ],
};

describe('a wrong value for any call', () => {
  it.each(Object.entries(CALLS))('raises an exception of Python or works, and never breaks the VM: %s', (_, calls) => {
    const run = play(`
from microbit import *
import machine, music, os, sys, time
for a in ${VALUES}:
    for call in (${calls.map((call) => `lambda: ${call},`).join(' ')}):
        try:
            call()
        except Exception:
            pass
print('still here')`).until(60_000);
    expect(run.ended()).toEqual({ kind: 'finished', exception: null });
    expect(run.printed()).toContain('still here');
  });
});
