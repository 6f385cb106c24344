import { describe, expect, it } from 'vitest';
import { microbitV2 } from '#board/boards/microbit-v2';
import { linesOf } from './testing/play';

const lines = (...texts: string[]): string => texts.join('\n');

describe('text for the device', () => {
  it('may be bytes, as they come from radio and files', () => {
    const program = lines(
      'import music, speech, log, os',
      "display.scroll(b'hi', 10)",
      "music.play(b'c4:1')",
      "music.play([b'c4:1'])",
      "speech.say(b'hi')",
      "open(b'n.txt', 'w').close()",
      "log.add({b'x': b'y'})",
      'print(os.listdir())',
    );
    expect(linesOf(program)).toEqual(["['main.py', 'n.txt']"]);
  });

  it('may be True or False on the display, which shows the word', () => {
    const program = lines(
      'print(took(display.scroll, True, 10), took(display.scroll, "True", 10))',
      'display.show(button_a.is_pressed(), 10)',
      'print(display.get_pixel(1, 0))',
    );
    const [times, pixel] = linesOf(program);
    expect(times?.split(' ')[0]).toBe(times?.split(' ')[1]);
    expect(pixel).toBe('9'); // the e of False
  });

  it('is nothing else: the device says what it cannot take', () => {
    const program = lines('import speech', 'err(display.scroll, None)', 'err(open, 3)', 'err(speech.say, [1])');
    expect(linesOf(program)).toEqual([
      "TypeError: can't convert 'NoneType' object to str implicitly",
      "TypeError: can't convert 'int' object to str implicitly",
      "TypeError: can't convert 'list' object to str implicitly",
    ]);
  });
});

describe('a recording of three seconds', () => {
  it('fits into memory once, 33000 samples of silence', () => {
    const program = lines(
      'import audio',
      'r = audio.AudioRecording(3000)',
      't = r.track()',
      'print(len(t), t[0], t[32999])',
    );
    const [, newest] = microbitV2.firmwares;
    const options = newest ? { type: microbitV2, firmware: newest } : undefined;
    expect(linesOf(program, {}, () => undefined, options)).toEqual(['33000 128 128']);
  });
});
