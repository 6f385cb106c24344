import { describe, expect, it } from 'vitest';
import { linesOf, play } from './testing/play';

describe('what is not simulated yet', () => {
  it('says so by its name', () => {
    const program = `
import radio, speech, log, power, audio
err(lambda: accelerometer.get_x())
err(lambda: compass.heading())
err(lambda: microphone.sound_level())
err(lambda: spi.init())
err(lambda: speaker.off())
err(lambda: Sound.HAPPY)
err(lambda: SoundEvent.LOUD)
err(lambda: radio.on())
err(lambda: speech.say('hi'))
err(lambda: log.add(x=1))
err(lambda: power.off())
err(lambda: audio.play(1))
err(lambda: uart.init(9600, tx=pin0))`;
    const names = [
      'microbit.accelerometer',
      'microbit.compass',
      'microbit.microphone',
      'microbit.spi',
      'microbit.speaker',
      'microbit.Sound',
      'microbit.SoundEvent',
      'radio.on',
      'speech.say',
      'log.add',
      'power.off',
      'audio.play',
      'microbit.uart on other pins than USB',
    ];
    expect(linesOf(program)).toEqual(names.map((name) => `NotImplementedError: ${name} is not simulated yet`));
  });
});

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

  it('knows the names with u', () => {
    const program =
      'import usys, sys, uos, os, ustruct, uarray, urandom, ucollections, uerrno\nprint(usys is sys, uos is os, sys.platform)';
    expect(linesOf(program)).toEqual(['True True microbit']);
  });

  it('brings the public names of microbit and nothing else', () => {
    const names = linesOf("print(' '.join(sorted(n for n in dir() if n[0] != '_' and n not in ('err', 'took'))))")[0];
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
