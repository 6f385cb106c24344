import { describe, expect, it } from 'vitest';
import { linesOf, play } from './testing/play';

const AT_MS = `
import speech
def exact(f, *a, **k):
    now = running_time()
    while running_time() == now: pass
    return took(f, *a, **k)
`;

describe('speech', () => {
  it('waits exactly as long as it speaks, and slower speech takes longer', () => {
    const program = `${AT_MS}
print(exact(speech.say, 'hello world'), exact(speech.say, 'hello world', speed=144), exact(speech.pronounce, 'IY'))
print(exact(speech.sing, '#115DOWWWWWW'), exact(speech.say, ''))`;
    expect(linesOf(program)).toEqual(['887 1775 120', '625 0']);
  });

  it('translates text to phonemes with stress and pauses', () => {
    const program = `
import speech
print(speech.translate('hello world'))
print(speech.translate('Exterminate, 2 robots!'))`;
    expect(linesOf(program)).toEqual(['/HEH4LOW WER4LD', 'EH4KSTERMIHNEYT, TUW4 ROW4BAATS.']);
  });

  it('refuses what it cannot read in the words of the device', () => {
    const program = `
import speech
err(speech.say, 'a' * 81)
err(speech.translate, 'grüezi')
err(speech.pronounce, 'XYZ')
err(speech.sing, '#DOW')
err(speech.say, 5)
err(speech.say, 'hi', pitch='low')
err(speech.say, 'hi', pin=pin3)`;
    expect(linesOf(program)).toEqual([
      'ValueError: text too long',
      'ValueError: could not parse input',
      'ValueError: Phoneme not understood',
      'ValueError: Phoneme not understood',
      "TypeError: can't convert 'int' object to str implicitly",
      "TypeError: can't convert str to int",
      'ValueError: Pin 3 in display mode',
    ]);
  });

  it('lets callbacks in while it speaks, and stops when it is interrupted', () => {
    const run = play(`
from microbit import *
import speech
run_every(lambda: print('tick'), ms=300)
try:
    speech.say('this is a long sentence')
except KeyboardInterrupt:
    print('stopped')
`);
    run.until(1000).vm.interrupt();
    expect(run.until(1010).printed()).toBe('tick\ntick\ntick\nstopped\n');
    expect(run.bench.board.sound.speechUntilUs).toBeLessThan(1_001_000);
  });

  it('takes pitch, mouth and throat, and the settings of the device that change nothing here', () => {
    const program = `${AT_MS}
print(exact(speech.say, 'hi', pitch=20, speed=72, mouth=200, throat=50, debug=False, mode=2, volume=4, pin=None))`;
    expect(Number(linesOf(program)[0])).toBe(192);
  });
});
