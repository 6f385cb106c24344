import { describe, expect, it } from 'vitest';
import { linesOf, play } from './testing/play';

describe('a melody in which something is no text', () => {
  it('sounds up to there, prints a line, and the program goes on', () => {
    const program = `
import music
t = running_time()
music.play(['c4:2', 5, 'e'])
print(200 < running_time() - t < 280)
music.play(('c:1', None), loop=True, wait=False)
print('on')
sleep(500)
music.play([None])`;
    const line = 'TypeError: expecting a str for note';
    expect(linesOf(program)).toEqual([line, 'True', 'on', line, line]);
  });
});

describe('music', () => {
  it('plays a note of four ticks at 120 beats a minute in 510 ms, a pitch of 100 ms in 114', () => {
    const program = `
import music
print(music.get_tempo(), exact(music.play, ['c4:4']), exact(music.play, 'c4:4'), exact(music.play, ['c', 'd:2', 'r:1']))
print(exact(music.pitch, 440, 100), exact(music.pitch, 440, 100, wait=False), exact(music.play, music.BA_DING))
music.set_tempo(bpm=60)
print(music.get_tempo())
music.reset()
print(music.get_tempo())`;
    // On the tick, 6 ms: c silent at 498, d from 510 to 750, the rest from 762 to 882, each followed by a gap of 10 ms.
    expect(linesOf(program)).toEqual(['(120, 4) 510 510 894', '114 0 516', '(60, 4)', '(120, 4)']);
  });

  it('has 21 melodies as tuples of notes, also after from music import *', () => {
    const program = `
import music
print(music.BA_DING, len(music.NYAN), len([n for n in music.__all__ if n[0].isupper()]))
from music import *
print(len(ODE), POWER_DOWN[0])`;
    expect(linesOf(program)).toEqual(["('b5:1', 'e6:3') 106 21", '30 g5:1']);
  });

  it('sounds on pin 0 while the program goes on, until stop', () => {
    const run = play(`
from microbit import *
import music
music.pitch(440)
sleep(100)
music.stop()
sleep(100)`);
    expect(run.until(50).bench.board.wire('P0').pwm?.periodUs).toBe(2272);
    expect(run.until(150).bench.board.wire('P0').pwm).toBeNull();
  });

  it('stops when the waiting program is interrupted', () => {
    const run = play(
      "import music\ntry:\n    music.play(music.ODE)\nexcept KeyboardInterrupt:\n    print('stopped')\n",
    );
    expect(run.until(300).bench.board.music.isPlaying).toBe(true);
    run.vm.interrupt();
    expect(run.until(400).printed()).toBe('stopped\n');
    expect(run.bench.board.music.isPlaying).toBe(false);
  });

  it('refuses mistakes in the words of the device', () => {
    const program = `
import music
err(music.pitch, -100, 10)
err(music.pitch, 2000000, 10)
err(music.pitch, 440, pin=pin3)
err(music.pitch, 440, pin=pin_speaker)
err(music.pitch, 440, pin=5)
err(music.play, 5)
err(lambda: music.nothing)
music.pitch(440)
err(pin0.write_digital, 1)
err(music.stop, pin3)
err(music.play, ['c', 5])`;
    expect(linesOf(program)).toEqual([
      'no error: None',
      'no error: None',
      'ValueError: Pin 3 in display mode',
      'ValueError: pin_speaker not allowed',
      'TypeError: expecting a pin',
      "TypeError: object 'int' isn't a tuple or list",
      "AttributeError: 'module' object has no attribute 'nothing'",
      'ValueError: Pin 0 in music mode',
      'ValueError: Pin 3 in display mode',
      'TypeError: expecting a str for note',
      'no error: None',
    ]);
  });

  it('plays each note exactly: a crotchet takes 510 ms, an empty tune one tick of 6 ms, an empty note a rest', () => {
    const program = `
import music
def at_tick():
    while running_time() % 6 != 0: pass
for tune in ('c4:4', ['c4:4', 'd'], ['c4:1', 'r:1'], [], ''):
    at_tick()
    print(took(music.play, tune), end=' ')
at_tick()
print(took(music.pitch, 440, 100), took(music.pitch, 440, 0))`;
    expect(linesOf(program)).toEqual(['510 1014 270 6 510 114 18']);
  });

  it('goes on when its pin is taken away: display.off() gives pin 3 back a second time', () => {
    const program = `
import music
display.off()
music.pitch(440, pin=pin3)
print(pin3.get_mode())
display.off()
sleep(100)
print(pin3.get_mode(), pin3.read_digital())
music.play(['c4:1', 'd'], pin=None)
display.on()
print(pin3.get_mode())`;
    expect(linesOf(program)).toEqual(['music', 'unused 0', 'display']);
  });

  it('sounds on the speaker alone with pin=None, and on a pin of choice', () => {
    const run = play(`
from microbit import *
import music
music.pitch(440, pin=None)
sleep(100)
music.pitch(880, pin=pin1)
sleep(100)
music.stop(pin1)
`);
    const { board } = run.until(50).bench;
    expect([board.wire('P0').pwm, board.music.frequencyHz]).toEqual([null, 1_000_000 / 2272]);
    expect(run.until(150).bench.board.wire('P1').pwm?.periodUs).toBe(1136);
    expect(run.until(250).bench.board.wire('P1').pwm).toBeNull();
  });
});
