import { describe, expect, it } from 'vitest';
import { microbitV2 } from '#board/boards/microbit-v2';
import type { Bench } from '#board/testing/bench';
import { linesOf, play } from './testing/play';

const newest = { type: microbitV2, firmware: microbitV2.firmwares.find(({ id }) => id === 'newest')! };

/** Sets sensors at these ms after the start. */
function later(events: readonly (readonly [ms: number, id: string, value: number | string])[]) {
  return ({ clock, board }: Bench): void => {
    for (const [ms, id, value] of events) clock.at(ms * 1000, () => board.sensors.set(id, value));
  };
}

describe('accelerometer', () => {
  it('gives whole mg, sampled every 20 ms', () => {
    const program = `
sleep(105)
print(accelerometer.get_x(), accelerometer.get_y(), accelerometer.get_z())
sleep(10)
print(accelerometer.get_x(), accelerometer.get_values())
sleep(10)
print(accelerometer.get_values(), accelerometer.get_strength())`;
    const setUp = later([
      [90, 'accelerometerX', 12],
      [110, 'accelerometerX', -300.7],
      [110, 'accelerometerY', 400],
      [110, 'accelerometerZ', -1200],
    ]);
    expect(linesOf(program, {}, setUp)).toEqual(['12 0 -1024', '12 (12, 0, -1024)', '(-300, 400, -1200) 1300']);
  });

  it('has gestures with their history', () => {
    const program = `
print(repr(accelerometer.current_gesture()), accelerometer.get_gestures(), accelerometer.was_gesture('shake'))
sleep(1000)
print(accelerometer.current_gesture(), accelerometer.is_gesture('shake'), accelerometer.is_gesture('left'))
print(accelerometer.get_gestures(), accelerometer.get_gestures())
print(accelerometer.was_gesture('shake'), accelerometer.was_gesture('shake'), accelerometer.was_gesture('left'))
sleep(1000)
print(accelerometer.current_gesture(), accelerometer.get_gestures(), accelerometer.was_gesture('2g'))`;
    const setUp = later([
      [300, 'gesture', 'left'],
      [400, 'gesture', 'shake'],
      [500, 'gesture', 'shake'],
      [1500, 'accelerometerZ', 1000],
    ]);
    expect(linesOf(program, {}, setUp)).toEqual([
      "'face up' ('face up',) False",
      'shake True False',
      "('left', 'shake', 'shake') ()",
      'True False True',
      "face down ('face down',) False",
    ]);
  });

  it('refuses what is no gesture, and takes any whole number of g', () => {
    const program = `
err(accelerometer.is_gesture, 'jump')
err(accelerometer.was_gesture, 'none')
err(accelerometer.was_gesture, 3)
err(accelerometer.set_range, '8')
err(accelerometer.set_range, 8.0)
accelerometer.set_range(7)
print(accelerometer.is_gesture('2g'), accelerometer.is_gesture(''), accelerometer)`;
    expect(linesOf(program)).toEqual([
      'ValueError: invalid gesture',
      'ValueError: invalid gesture',
      "TypeError: can't convert 'int' object to str implicitly",
      "TypeError: can't convert str to int",
      "TypeError: can't convert float to int",
      'False False <MicroBitAccelerometer>',
    ]);
  });

  it('reaches 8 g after set_range(8)', () => {
    const run = play('from microbit import *\naccelerometer.set_range(8)\nsleep(200)\nprint(accelerometer.get_z())');
    run.until(100).bench.board.sensors.set('accelerometerZ', -7999);
    expect(run.until(300).printed()).toBe('-7999\n');
  });
});

describe('compass', () => {
  it('gives heading, field and strength, and is calibrated', () => {
    const program = `
print(compass.is_calibrated(), compass.heading(), compass.get_x(), compass.get_y(), compass.get_z())
print(compass.get_field_strength(), took(compass.calibrate))
compass.clear_calibration()
print(compass.is_calibrated())
compass.calibrate()
print(compass.is_calibrated())`;
    const setUp = ({ board }: Bench): void => {
      board.sensors.set('compassHeading', 359.5);
      board.sensors.set('compassX', 3000);
      board.sensors.set('compassZ', -4000);
    };
    expect(linesOf(program, {}, setUp)).toEqual(['True 359 3000 0 -4000', '5000 0', 'False', 'True']);
  });
});

describe('microphone', () => {
  it('tells loud from quiet', () => {
    const program = `
print(microphone.current_event(), microphone.sound_level(), microphone.get_events())
sleep(1000)
print(microphone.current_event(), microphone.is_event(SoundEvent.LOUD), microphone.sound_level())
sleep(1000)
print(microphone.current_event() == SoundEvent.QUIET, microphone.get_events())
print([microphone.was_event(e) for e in (SoundEvent.LOUD, SoundEvent.LOUD, SoundEvent.QUIET)])
microphone.set_threshold(SoundEvent.LOUD, 15)
print(microphone.current_event())`;
    const setUp = later([
      [500, 'soundLevel', 200],
      [1500, 'soundLevel', 20],
    ]);
    expect(linesOf(program, {}, setUp)).toEqual([
      "SoundEvent('quiet') 0 ()",
      "SoundEvent('loud') True 200",
      "True (SoundEvent('loud'), SoundEvent('quiet'))",
      '[True, False, True]',
      "SoundEvent('loud')",
    ]);
  });

  it('refuses what is no sound, and has no newer names in v2.1.2', () => {
    const program = `
err(microphone.is_event, 'loud')
err(microphone.was_event, None)
err(microphone.set_threshold, 1, 2)
err(microphone.set_threshold, SoundEvent.LOUD, 1.5)
err(lambda: SoundEvent.CLAP)
err(lambda: microphone.sound_level_db())
err(lambda: microphone.record(100))`;
    expect(linesOf(program)).toEqual([
      'ValueError: invalid sound',
      'ValueError: invalid sound',
      'ValueError: invalid sound',
      "TypeError: can't convert float to int",
      "AttributeError: type object 'MicroBitSoundEvent' has no attribute 'CLAP'",
      "AttributeError: 'MicroBitMicrophone' object has no attribute 'sound_level_db'",
      "AttributeError: 'MicroBitMicrophone' object has no attribute 'record'",
    ]);
  });

  it('hears claps and knows dB with the newest firmware', () => {
    const program = `
from microbit import *
microphone.get_events()
sleep(1000)
print(microphone.get_events(), microphone.was_event(SoundEvent.CLAP), microphone.sound_level_db())
try:
    microphone.set_threshold(SoundEvent.CLAP, 1)
except ValueError as e:
    print(e)`;
    const setUp = later([
      [500, 'soundLevel', 255],
      [580, 'soundLevel', 0],
    ]);
    expect(play(program, {}, setUp, newest).until(2000).printed()).toBe(
      "(SoundEvent('loud'), SoundEvent('clap'), SoundEvent('quiet')) True 52.0\ninvalid sound\n",
    );
  });
});

describe('recording (newest firmware)', () => {
  const printedBy = (program: string, setUp?: (bench: Bench) => void): string =>
    play(`from microbit import *\nimport audio\n${program}`, {}, setUp, newest).until(10_000).printed();

  it('waits for its duration and is as loud as it was', () => {
    const program = `
t = running_time()
r = microphone.record(500, rate=8000)
print(running_time() - t, len(r.track()), r.get_rate(), type(r).__name__)
half = r.track(start_ms=0, end_ms=250)
rest = r.track(start_ms=250)
print(max(half), max(rest), min(rest))`;
    const setUp = later([[250, 'soundLevel', 255]]);
    expect(printedBy(program, setUp)).toBe('500 4000 8000 AudioRecording\n128 255 1\n');
  });

  it('takes any rate that is a number, at once a million samples a second and at most that', () => {
    const program = `
r = audio.AudioRecording(10)
for rate in (2**31, 10**10, 1e30, 1000000):
    t = running_time()
    track = microphone.record_into(r, rate)
    print(len(track), running_time() - t <= 1)
    audio.play(track)
for rate in (0, -2**40, '5', None):
    try:
        r.set_rate(rate)
    except Exception as e:
        print(repr(e))
print(len(audio.AudioTrack('text')), audio.AudioTrack(b'ab')[0])`;
    expect(printedBy(program)).toBe(
      '110 True\n'.repeat(4) +
        "ValueError('rate out of bounds',)\n".repeat(2) +
        `TypeError("can't convert str to float",)\nTypeError("can't convert NoneType to float",)\n4 97\n`,
    );
  });

  it('goes on in the background until it is stopped', () => {
    const program = `
r = audio.AudioRecording(1000, 10000)
microphone.record_into(r, rate=10000, wait=False)
print(microphone.is_recording())
sleep(300)
microphone.stop_recording()
print(microphone.is_recording())
track = r.track()
print(max(track[:3000]), max(track[3100:]))
try:
    microphone.record_into(bytearray(5))
except TypeError as e:
    print(e)
microphone.set_sensitivity(microphone.SENSITIVITY_HIGH)`;
    const setUp = ({ board }: Bench): void => board.sensors.set('soundLevel', 128);
    expect(printedBy(program, setUp)).toBe('True\nFalse\n192 128\nexpecting an AudioRecording or AudioTrack\n');
  });
});

describe('temperature', () => {
  it('is a whole number, read once a second', () => {
    const program = `
for i in range(3):
    print(temperature())
    sleep(600)`;
    const setUp = later([
      [300, 'temperature', 25.9],
      [1100, 'temperature', 30],
    ]);
    expect(linesOf(program, {}, setUp)).toEqual(['21', '21', '25']);
  });
});
