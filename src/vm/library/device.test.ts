import { describe, expect, it } from 'vitest';
import { linesOf, play } from './testing/play';

describe('import', () => {
  it('hides what only this build of MicroPython has', () => {
    const program = `
for name in ('js', 'jsffi', 'asyncio', 're', 'uctypes', 'ujson', 'uasyncio', 'io', 'cmath', 'os.path', 'pathlib', 'nothing'):
    try:
        __import__(name)
        print('imported', name)
    except ImportError as e:
        print(e)`;
    const names = 'js jsffi asyncio re uctypes ujson uasyncio io cmath os.path pathlib nothing'.split(' ');
    expect(linesOf(program)).toEqual(names.map((name) => `no module named '${name}'`));
  });

  it('prefers a file of the user’s to a module of ours or of MicroPython', () => {
    const files = { 'json.py': 'dumps = 5', 'music.py': "print('mine')" };
    expect(linesOf('import json, music\nprint(json.dumps)', files)).toEqual(['mine', '5']);
  });

  it('finds what is built in whatever became of sys.modules and sys.path', () => {
    const program = `
import sys
del sys.modules['microbit']
import microbit
sys.modules.clear()
import music
sys.path.clear()
import neopixel, radio
print(microbit, microbit.display is display, music, neopixel, radio)`;
    expect(linesOf(program)).toEqual([
      "<module 'microbit'> True <module 'music'> <module 'neopixel'> <module 'radio'>",
    ]);
  });

  it('gives builtins that cannot be changed: no program takes away what the device itself needs', () => {
    const program = `
import builtins
print(builtins, builtins.print is print, builtins.open is open, builtins.input is input)
err(lambda: setattr(builtins, 'range', None))
err(lambda: builtins.__dict__)
display.show('ab', 10)
import log
log.add(x=len(range(3)))
print('fine')`;
    expect(linesOf(program)).toEqual([
      "<module 'builtins'> True True True",
      "AttributeError: 'module' object has no attribute 'range'",
      "AttributeError: 'module' object has no attribute '__dict__'", // there it is, and cannot be changed either
      'fine',
    ]);
  });

  it('knows the names with u', () => {
    const program =
      'import usys, sys, uos, os, ustruct, uarray, urandom, ucollections, uerrno\nprint(usys is sys, uos is os, sys.platform)';
    expect(linesOf(program)).toEqual(['True True microbit']);
  });

  it('brings the public names of microbit and nothing else', () => {
    const names = linesOf(
      "print(' '.join(sorted(n for n in dir() if n[0] != '_' and n not in ('err', 'took', 'exact'))))",
    )[0];
    expect(names?.split(' ').filter((name) => !/^pin\d+$/.test(name))).toEqual(
      'Image Sound SoundEvent accelerometer audio button_a button_b compass display i2c microphone panic pin_logo pin_speaker reset run_every running_time scale set_volume sleep speaker spi temperature uart ws2812_write'.split(
        ' ',
      ),
    );
  });
});

describe('microbit functions', () => {
  it('scale like the device', () => {
    const program = `
print(scale(50, from_=(0, 100), to=(0, 1023)), scale(30, from_=(0.0, 100.0), to=(32.0, 212.0)), scale(1, (0, 2), (0, 5)))
print(temperature())`;
    expect(linesOf(program)).toEqual(['512 86.0 2', '21']);
  });

  it('panic shows a sad face and ends the program', () => {
    const run = play("from microbit import *\npanic(12)\nprint('never')").until(100);
    expect([run.ended()?.kind, run.printed()]).toEqual(['panic', '']);
    expect(run.bench.picture()).toBe('.....\n.9.9.\n.....\n.999.\n9...9');
  });

  it('reset starts the program anew and keeps its files', () => {
    const run = play(`
from microbit import *
import os
if 'seen' in os.listdir():
    print('again')
else:
    print('first')
    open('seen', 'w').close()
    reset()`);
    expect(run.until(5000).printed()).toBe('first\nagain\n');
  });
});

describe('machine', () => {
  it('reads what the chip says of itself, and says plainly what is not simulated', () => {
    const program = `
import machine
print(hex(machine.mem32[0x10000100]), hex(machine.mem16[0x10000102]), hex(machine.mem8[0x10000101]))
print(machine.mem32[0x10000060] == int.from_bytes(machine.unique_id()[:4], 'little'), machine.freq())
err(lambda: machine.mem32[0x10000101])
err(lambda: machine.mem32[0x50000510])
err(machine.mem8.__setitem__, 0x20000000, 1)
err(lambda: machine.mem8['x'])`;
    expect(linesOf(program)).toEqual([
      '0x52833 0x5 0x28',
      'True 64000000',
      'ValueError: address 10000101 is not aligned to 4 bytes',
      'NotImplementedError: reading machine.mem32[0x50000510] is not simulated',
      'NotImplementedError: writing machine.mem8[0x20000000] is not simulated',
      "TypeError: can't convert str to int",
    ]);
  });

  it('gives the state of interrupts as the device does: 0 while they are on', () => {
    expect(
      linesOf(
        'import machine\na = machine.disable_irq()\nb = machine.disable_irq()\nmachine.enable_irq(a)\nprint(a, b, machine.disable_irq())',
      ),
    ).toEqual(['0 1 0']);
  });
});

describe('run_every and scale', () => {
  it('run_every gives a timer and not the function, with every unit of time', () => {
    const program = `
n = 0
@run_every(days=0, h=0, min=0, s=0, ms=120)
def tick():
    global n
    n += 1
print(tick)
run_every(lambda: print('once', n), s=1)
sleep(1100)
print(n)
err(run_every, ms='x')`;
    expect(linesOf(program)).toEqual(['<run_every>', 'once 8', '9', "TypeError: can't convert str to int"]);
  });

  it('scale from a range without width, and beyond 32 bits, gives what C makes of it', () => {
    const program = `
print([scale(value, (3, 3), (0, 100)) for value in (5, 3, 2)], [scale(value, (3, 3), (0, 1.0)) for value in (5, 3)])
print(scale(1, (0, 1), (0, 5e9)) > 4e9, scale(10**6, (0, 1), (0, 10**6)), scale(float('inf'), (0, 1), (0, -1)))`;
    expect(linesOf(program)).toEqual(['[2147483647, 0, -2147483648] [inf, nan]', 'True 2147483647 -2147483648']);
  });

  it('scale refuses what is no pair in the words of the device', () => {
    expect(
      linesOf('err(scale, 1, 5, (0, 1))\nerr(scale, 1, (0, 1), (0, 1, 2))\nerr(scale, "a", (0, 1), (0, 1))'),
    ).toEqual([
      "TypeError: object 'int' isn't a tuple or list",
      'ValueError: requested length 2 but object has length 3',
      "TypeError: can't convert str to float",
    ]);
  });
});
