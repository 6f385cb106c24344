import type { Board } from '#board/board';
import type { Pin } from '#board/wires/pin';
import { BUILT_IN_SOUNDS } from '#board/sound/built-in-sounds';
import { readEffect } from '#board/sound/effect';
import { phonemesOf } from '#board/sound/letter-rules';
import { utter, type Voice } from '#board/sound/utter';
import type { Rng } from '#core/rng';
import { numberOf, ownOf, textOf, wholeOf } from '../arguments';
import { pinsByNumber } from './pins';
import type { Machine, SyscallTable, Value, Wait } from '../syscall';

/** The speaker's own pin cannot be chosen: it sounds anyway (microbit_pinaudio.c). */
export const SPEAKER_PIN = 'pin_speaker';
export const SPEAKER_REFUSED = 'pin_speaker not allowed';

/**
 * Audio and speech. A pin is given by its number, −1 for the speaker alone.
 *
 * - audio_pin(pin) → None, or the device's words if the pin is held; audio and speech sound there from now on
 * - audio_effect(text): plays a built-in sound by name or an effect of 72 digits a part; anything else is silent
 * - audio_open(callback): a series of frames begins, the callback is queued whenever the next one is due ·
 *   audio_frame(address, length, rate): passes it on · audio_close(): there are no more
 * - audio_frames() → whether a series goes on · audio_level() → present loudness
 * - audio_playing() → whether an effect or frames sound · audio_wait() waits until they have ended → True if a callback
 *   came in between · audio_stop(with effects), audio_stop_effect()
 * - samples_add(address, address, length, ±1), samples_multiply(address, length, factor): sums and products in place
 * - set_volume(0 … 255) · speaker(on)
 * - speech_translate(text) → phonemes, or None if it cannot be read
 * - speech_say(phonemes, pitch | speed << 8 | mouth << 16, throat, sings) → True, or False if these are not phonemes ·
 *   speech_wait() waits until it has been said → True if a callback came in between · speech_stop()
 */
export function createSoundCalls(machine: Machine, board: Board, rng: Rng): SyscallTable {
  return {
    ...audioCalls(machine, board, rng.fork('sound')),
    ...sampleCalls(machine),
    ...outputCalls(machine, board),
    ...speechCalls(machine, board),
  };
}

function audioCalls(machine: Machine, board: Board, chance: Rng): SyscallTable {
  const { sound } = board;
  const { stream } = sound;
  const { clock } = machine;
  const pins = pinsByNumber(board);
  const pinOf = (n: Value | undefined): Pin | null => pins[wholeOf(n) ?? -1] ?? null;
  const isPlaying = (): boolean => stream.isOpen || sound.effectUntilUs > clock.nowUs;
  const spending = withCost(machine, board);
  machine.onEnd(() => stream.close());
  return {
    audio_pin: spending((n) => {
      const pin = pinOf(n);
      return pin?.name === SPEAKER_PIN ? SPEAKER_REFUSED : sound.route.select(pin, 'audio');
    }),
    audio_effect: spending((text) => {
      const parts = readEffect(ownOf(BUILT_IN_SOUNDS, text) ?? textOf(text), chance);
      if (parts) sound.playEffect(parts);
      return null;
    }),
    audio_open: spending((callback) => {
      sound.silence('samples');
      stream.open(() => machine.schedule(wholeOf(callback) ?? 0));
      return null;
    }),
    audio_frame: spending((address, length, rate) => {
      const samples = [...machine.memory(wholeOf(address) ?? 0, wholeOf(length) ?? 0)];
      stream.write({ samples, rate: Math.max(wholeOf(rate) ?? 1, 1) });
      return null;
    }),
    audio_close: spending(() => {
      stream.close();
      return null;
    }),
    audio_frames: () => stream.isOpen,
    audio_level: spending(() => stream.level),
    audio_playing: spending(isPlaying),
    audio_wait: (): Wait => ({
      get untilUs() {
        return stream.isOpen ? Infinity : Math.max(clock.nowUs, sound.effectUntilUs);
      },
      ready: () => !isPlaying(),
      result: isPlaying,
    }),
    audio_stop: spending((withEffects) => {
      sound.silence('samples');
      if (withEffects === true) sound.silence('effect');
      return null;
    }),
    audio_stop_effect: spending(() => {
      sound.silence('effect');
      return null;
    }),
  };
}

/** Arithmetic of frames: modaudio.c, add_into and mult. */
function sampleCalls(machine: Machine): SyscallTable {
  return {
    samples_add: (address, other, length, sign) => {
      const samples = machine.memory(wholeOf(address) ?? 0, wholeOf(length) ?? 0);
      const added = machine.memory(wholeOf(other) ?? 0, samples.length);
      for (const [i, sample] of samples.entries())
        samples[i] = clamp(sample + ((added[i] ?? 128) - 128) * (sign === -1 ? -1 : 1));
      return null;
    },
    samples_multiply: (address, length, factor) => {
      const samples = machine.memory(wholeOf(address) ?? 0, wholeOf(length) ?? 0);
      const scaled = Math.trunc(Math.fround(numberOf(factor) ?? 0) * FIXED_POINT);
      for (const [i, sample] of samples.entries())
        samples[i] = clamp(Math.floor(((sample - 128) * scaled) / FIXED_POINT) + 128);
      return null;
    },
  };
}

function outputCalls(machine: Machine, board: Board): SyscallTable {
  const { sound } = board;
  const spending = withCost(machine, board);
  return {
    set_volume: spending((volume) => {
      sound.setVolume(wholeOf(volume) ?? -1);
      return null;
    }),
    speaker: spending((isOn) => {
      sound.setSpeaker(isOn === true);
      return null;
    }),
  };
}

function speechCalls(machine: Machine, board: Board): SyscallTable {
  const { sound } = board;
  const { clock } = machine;
  const spending = withCost(machine, board);
  const isSpeaking = (): boolean => sound.speechUntilUs > clock.nowUs;
  return {
    speech_translate: spending((text) => phonemesOf(textOf(text))),
    speech_say: spending((phonemes, settings, throat, sings) => {
      const packed = wholeOf(settings) ?? 0;
      const voice: Voice = {
        pitch: packed & 0xff,
        speed: (packed >> 8) & 0xff,
        mouth: (packed >> 16) & 0xff,
        throat: (wholeOf(throat) ?? 0) & 0xff,
        sings: sings === true,
      };
      const utterance = utter(textOf(phonemes), voice);
      if (utterance) sound.speak(utterance);
      return utterance !== null;
    }),
    speech_wait: (): Wait => ({
      untilUs: Math.max(clock.nowUs, sound.speechUntilUs),
      ready: () => !isSpeaking(),
      result: isSpeaking,
    }),
    speech_stop: spending(() => {
      sound.silence('speech');
      return null;
    }),
  };
}

const FIXED_POINT = 32_768; // modaudio.c: factors have 15 bits behind the point
const clamp = (sample: number): number => Math.min(255, Math.max(0, sample));

/** Gives syscalls the cost that every call of the board has. */
function withCost(machine: Machine, board: Board) {
  return (answer: (...args: readonly (Value | undefined)[]) => Value) =>
    (...args: readonly (Value | undefined)[]): Value => {
      machine.spend(board.type.costsUs.callUs);
      return answer(...args);
    };
}
