import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { linesOf, type Device } from './testing/play';

/** The errors of setting an attribute that no object of the device has, and of changing one that its type has. */
function refusals(values: readonly string[], device: Device = {}): string[] {
  const program = `
import audio, machine
def attempt(thing, name, value):
    try:
        setattr(thing, name, value)
        print('taken:', thing)
    except AttributeError as e:
        print(e)
for thing in (${values.join(', ')},):
    attempt(thing, 'volume', 100)`;
  return linesOf(program, {}, undefined, device);
}

const NO_VOLUME = "object has no attribute 'volume'";

describe('an attribute that the device does not have', () => {
  it('is refused by the objects of its modules', () => {
    const things: Readonly<Record<string, string>> = {
      'audio.SoundEffect()': 'MicroBitSoundEffect',
      'Image("9")': 'MicroBitImage',
      'Image.HEART': 'MicroBitImage',
      'Image(2, 2) + Image(2, 2)': 'MicroBitImage',
      'audio.AudioFrame()': 'AudioFrame',
      'Sound.HAPPY': 'MicroBitSound',
      'SoundEvent.LOUD': 'MicroBitSoundEvent',
      'open("main.py")': 'TextIO',
      'open("main.py", "rb")': 'FileIO',
      'run_every(ms=50)': 'run_every',
      pin0: 'MicroBitTouchPin',
      display: 'MicroBitDisplay',
    };
    expect(refusals(Object.keys(things))).toEqual(Object.values(things).map((type) => `'${type}' ${NO_VOLUME}`));
  });

  it('is refused by what a firmware or a board has besides', () => {
    const newest = { firmware: microbitV2.firmwares[1] };
    expect(refusals(['audio.AudioRecording(9)', 'audio.AudioRecording(9).track()'], newest)).toEqual([
      `'AudioRecording' ${NO_VOLUME}`,
      `'AudioTrack' ${NO_VOLUME}`,
    ]);
    const program = `
import calliope_mini
err(setattr, calliope_mini.led, 'green', 1)`;
    expect(linesOf(program, {}, undefined, { type: calliopeMini3 })).toEqual([
      "AttributeError: 'CalliopeLED' object has no attribute 'green'",
    ]);
  });

  it('is refused by the types, whose own attributes nobody changes either', () => {
    const types = [
      'Image',
      'Sound',
      'SoundEvent',
      'audio.SoundEffect',
      'audio.AudioFrame',
      'type(pin0)',
      'type(display)',
    ];
    expect(refusals(types)).toEqual(types.map(() => `'type' ${NO_VOLUME}`));
    const program = `
def change():
    Image.HEART = Image.SAD
def remove():
    del Image.HEART
err(change)
err(remove)
print(repr(Image.HEART)[7:12], audio.SoundEffect(duration=9).duration)`;
    expect(linesOf(program)).toEqual([
      "AttributeError: 'type' object has no attribute 'HEART'",
      "AttributeError: 'type' object has no attribute 'HEART'",
      '09090 9',
    ]);
  });

  it('is taken by a class of the program that builds on one of the device', () => {
    const program = `
class Sprite(Image):
    def __init__(self, x):
        super().__init__('9')
        self.x = x
s = Sprite(3)
s.y = 4
Sprite.z = 5
print(s.x, s.y, s.z, s.width())`;
    expect(linesOf(program)).toEqual(['3 4 5 5']);
  });
});
