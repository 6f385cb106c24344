import type { Board } from '#board/board';
import { GESTURE_NAMES } from '#board/sensors/gestures';
import type { SoundKind } from '#board/sensors/microphone';
import { numberOf, wholeOf } from '../arguments';
import type { Machine, Syscall, SyscallTable, Value } from '../syscall';

const SOUND_KINDS: readonly SoundKind[] = ['quiet', 'loud', 'clap'];
const SEPARATOR = '\n';
/** One sample a microsecond: the clock has no finer resolution. */
const FASTEST_HZ = 1_000_000;
/** Upper limit for a recording: the device's heap. */
const MOST_SAMPLES = 64 * 1024;

/**
 * The board's sensors. Gestures are given by their places among gesture_names(), sounds by name; lists are separated by
 * newlines.
 *
 * - temperature() → whole °C · light_level()
 * - acceleration(axis 0 … 2) → mg, acceleration_too(axis): the same within one call · acceleration_strength() ·
 *   acceleration_range(g)
 * - gesture_names() · gesture() · gesture_was(place) → bool · gestures() → names
 * - compass_heading() · compass_field(axis), compass_strength() → nT · compass_is_calibrated() · compass_calibrate() ·
 *   compass_forget()
 * - mic_level() · mic_level_db() · mic_event() · mic_was(kind) → bool · mic_events() · mic_threshold(kind, level) ·
 *   mic_sensitivity(gain)
 * - mic_record(address, length, rate) begins · mic_recorded() waits → True if it goes on (a callback came in between) ·
 *   mic_is_recording() · mic_stop() · mic_count() → samples recorded so far
 */
export function createSenseCalls(machine: Machine, board: Board): SyscallTable {
  const { callUs, motionUs } = board.type.costsUs;
  const priced = (calls: SyscallTable, us: number): SyscallTable =>
    Object.fromEntries(
      Object.entries(calls).map(([name, call]): [string, Syscall] => [
        name,
        (...args) => {
          machine.spend(us);
          return call(...args);
        },
      ]),
    );
  const motion = priced({ ...motionCalls(board), ...compassCalls(board) }, motionUs);
  const others = priced(
    {
      temperature: () => Math.trunc(board.thermometer.value),
      ...microphoneCalls(board),
      ...recordingCalls(machine, board),
    },
    callUs,
  );
  return { ...motion, ...others, ...furtherCalls(machine, board) };
}

/** Calls with other costs: names, the light, further parts of a call that is paid (three values: one object more). */
function furtherCalls(machine: Machine, { motion, sensors, type }: Board): SyscallTable {
  return {
    gesture_names: () => GESTURE_NAMES.join(SEPARATOR),
    light_level: () => {
      machine.spend(type.costsUs.callUs);
      return sensors.get('lightLevel');
    },
    acceleration_too: (axis) => {
      if (axis === 1) machine.spend(type.costsUs.allocationUs);
      return motion.acceleration[axisOf(axis)];
    },
  };
}

const AXES = ['x', 'y', 'z'] as const;
const axisOf = (value: Value | undefined): 'x' | 'y' | 'z' => AXES[wholeOf(value) ?? 0] ?? 'x';

function motionCalls({ motion }: Board): SyscallTable {
  return {
    acceleration: (axis) => motion.acceleration[axisOf(axis)],
    acceleration_strength: () => motion.strength,
    acceleration_range: (g) => {
      motion.setRange(wholeOf(g) ?? 0);
      return null;
    },
    gesture: () => GESTURE_NAMES.indexOf(motion.gesture),
    gesture_was: (place) => motion.wasGesture(GESTURE_NAMES[wholeOf(place) ?? 0] ?? ''),
    gestures: () => motion.takeGestures().join(SEPARATOR),
  };
}

function compassCalls({ compass }: Board): SyscallTable {
  return {
    compass_heading: () => compass.heading(),
    compass_field: (axis) => compass.field[axisOf(axis)],
    compass_strength: () => compass.fieldStrength,
    compass_is_calibrated: () => compass.isCalibrated,
    compass_calibrate: () => {
      compass.calibrate();
      return null;
    },
    compass_forget: () => {
      compass.clearCalibration();
      return null;
    },
  };
}

function microphoneCalls({ microphone }: Board): SyscallTable {
  const listening = (answer: (name: Value | undefined, value: Value | undefined) => Value): Syscall => {
    return (name, value) => {
      microphone.listen();
      return answer(name, value);
    };
  };
  const kindOf = (name: Value | undefined): SoundKind => SOUND_KINDS.find((kind) => kind === name) ?? 'quiet';
  return {
    mic_level: listening(() => microphone.soundLevel),
    mic_level_db: listening(() => microphone.soundLevelDb),
    mic_event: listening(() => microphone.currentEvent),
    mic_was: listening((name) => microphone.wasEvent(kindOf(name))),
    mic_events: listening(() => microphone.takeEvents().join(SEPARATOR)),
    mic_threshold: listening((name, level) => {
      microphone.setThreshold(name === 'loud' ? 'loud' : 'quiet', wholeOf(level) ?? 0);
      return null;
    }),
    mic_sensitivity: (gain) => {
      microphone.setSensitivity(numberOf(gain) ?? 0);
      return null;
    },
  };
}

function recordingCalls(machine: Machine, { microphone }: Board): SyscallTable {
  let count = 0;
  // Recordings land in the program's memory: not after its end.
  machine.onEnd(() => microphone.stopRecording());
  return {
    mic_record: (address, length, rate) => {
      const start = wholeOf(address) ?? 0;
      count = 0;
      microphone.record({
        rateHz: Math.min(Math.max(wholeOf(rate) ?? 1, 1), FASTEST_HZ),
        length: Math.min(wholeOf(length) ?? 0, MOST_SAMPLES),
        write: (offset, samples) => {
          machine.memory(start + offset, samples.length).set(samples);
          count = offset + samples.length;
        },
      });
      return null;
    },
    mic_recorded: () => ({
      untilUs: microphone.isRecording ? Infinity : machine.clock.nowUs,
      ready: () => !microphone.isRecording,
      result: () => microphone.isRecording,
    }),
    mic_is_recording: () => microphone.isRecording,
    mic_stop: () => {
      microphone.stopRecording();
      return null;
    },
    mic_count: () => count,
  };
}
