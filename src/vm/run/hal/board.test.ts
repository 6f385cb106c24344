import { describe, expect, it } from 'vitest';
import { calliopeMini3 } from '#board/boards/calliope-mini-3';
import { microbitV2 } from '#board/boards/microbit-v2';
import { createBench } from '#board/testing/bench';
import { createBoardCalls } from './board';
import type { SyscallTable, Value } from '../syscall';

/** Asks for the first, second … until there is none. */
function all(calls: SyscallTable, name: string): Value[] {
  const found: Value[] = [];
  for (let place = 0; ; place++) {
    const answer = calls[name]?.(place) as Value;
    if (answer === null) return found;
    found.push(answer);
  }
}

const callsOf = (...device: Parameters<typeof createBench>) => createBoardCalls(createBench(...device).board);

describe('board syscalls', () => {
  it('name the pins with number and class', () => {
    const pins = all(callsOf(calliopeMini3), 'board_pin');
    expect(pins).toHaveLength(29);
    expect(pins).toEqual(
      expect.arrayContaining([
        'pin3 3 touch',
        'pin_A1_RX 16 analog',
        'pin_M_MODE 26 digital',
        'pin_logo 30 touch-only',
      ]),
    );
    expect(all(callsOf(), 'board_pin')).toHaveLength(21);
  });

  it('name the modules and the pins of buses', () => {
    const calls = callsOf(calliopeMini3);
    expect(all(calls, 'board_module')).toEqual(['calliopemini', 'calliope_mini', 'microbit']);
    expect(['scl', 'sda', 'rgb', 'other'].map((role) => calls['board_role']?.(role))).toEqual([19, 20, 21, -1]);
    expect(calls['board_rgb_count']?.()).toBe(3);
    expect([callsOf()['board_role']?.('rgb'), callsOf()['board_rgb_count']?.()]).toEqual([-1, 0]);
  });

  it('tell the firmware that the board runs', () => {
    const newest = callsOf(microbitV2, microbitV2.firmwares[1]);
    expect([newest['board_has']?.('clap'), callsOf()['board_has']?.('clap'), newest['board_has']?.('wings')]).toEqual([
      true,
      false,
      false,
    ]);
    expect([0, 1, 2].map((part) => callsOf()['board_micropython']?.(part))).toEqual([1, 18, 0]);
    expect(callsOf()['board_text']?.('release')).toBe('2.1.2');
    expect(callsOf()['board_text']?.('banner')).toContain('MicroPython v1.18');
  });
});
