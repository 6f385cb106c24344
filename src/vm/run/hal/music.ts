import type { Board } from '#board/board';
import { textOf, wholeOf } from '../arguments';
import type { ConsolePort } from '../console-port';
import { pinsByNumber } from './pins';
import { SPEAKER_PIN, SPEAKER_REFUSED } from './sound';
import type { Machine, SyscallTable, Value, Wait } from '../syscall';

/** Printed by the player when its turn comes to something that is no string: modmusic.c, microbit_music_tick. */
const NO_NOTE = new TextEncoder().encode('TypeError: expecting a str for note\n');

/**
 * Music. A pin is given by its number, −1 for the speaker alone.
 *
 * - music_play(notes, pin, loop, isCut), music_pitch(Hz, ms, pin) → None, or the device's words if it cannot; each note
 *   has a newline before it; cut, they end in what is no note: a line on the console, and no more
 * - music_busy() waits until the present tune has ended or been replaced → True if a callback came in between
 * - music_stop(pin) → None, or the device's words if the pin is held · music_silence() · music_reset() ·
 *   music_set_tempo(bpm, ticks), 0 leaves it
 * - music_bpm(), music_ticks()
 */
export function createMusicCalls(machine: Machine, board: Board, port: ConsolePort): SyscallTable {
  const { music } = board;
  const { callUs, toneUs } = board.type.costsUs;
  const pins = pinsByNumber(board);
  let started = 0;
  const pinOf = (n: Value | undefined) => pins[wholeOf(n) ?? -1] ?? null;
  const refusal = (n: Value | undefined) => (pinOf(n)?.name === SPEAKER_PIN ? SPEAKER_REFUSED : null);
  return {
    music_play: (notes, pin, loop, isCut) => {
      machine.spend(callUs);
      started++;
      const all = textOf(notes).split('\n').slice(1);
      if (isCut !== true) return refusal(pin) ?? music.play(all, { pin: pinOf(pin), loop: loop === true });
      return refusal(pin) ?? music.play(all, { pin: pinOf(pin), loop: false, onOver: () => port.write(NO_NOTE) });
    },
    music_pitch: (hz, ms, pin) => {
      machine.spend(toneUs);
      started++;
      return refusal(pin) ?? music.pitch(wholeOf(hz) ?? 0, wholeOf(ms) ?? -1, pinOf(pin));
    },
    music_busy: (): Wait => {
      const awaited = started;
      const isOver = (): boolean => started !== awaited || !music.isPlaying;
      return { untilUs: isOver() ? machine.clock.nowUs : Infinity, ready: isOver, result: () => !isOver() };
    },
    music_stop: (pin) => {
      machine.spend(callUs);
      started++;
      const problem = refusal(pin) ?? board.sound.route.giveBack(pinOf(pin));
      if (problem === null) music.stop();
      return problem;
    },
    music_silence: () => {
      machine.spend(callUs);
      started++;
      music.stop();
      return null;
    },
    music_reset: () => {
      machine.spend(callUs);
      music.resetTempo();
      return null;
    },
    music_set_tempo: (bpm, ticks) => {
      machine.spend(callUs);
      music.setTempo({ bpm: wholeOf(bpm) ?? 0, ticks: wholeOf(ticks) ?? 0 });
      return null;
    },
    music_bpm: () => music.tempo.bpm,
    music_ticks: () => music.tempo.ticks,
  };
}
