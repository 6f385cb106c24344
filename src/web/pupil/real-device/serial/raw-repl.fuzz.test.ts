import { describe, expect, it } from 'vitest';
import { fuzzRuns } from '#core/testing/fuzz-runs';
import { BANNER, problemOf, scripted } from './testing/scripted-device';

describe('a device that answers rubbish', { timeout: 120_000 }, () => {
  /** Numerical Recipes' linear congruential generator. */
  const chance = (seed: number): ((below: number) => number) => {
    let state = seed;
    return (below) => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return Math.floor((state / 2 ** 32) * below);
    };
  };
  const TOKENS = [BANNER, 'OK', '\x04', '>', '\x04\x04>', 'OK\x04\x04>', 'OK1\r\n\x04\x04>', 'OK-\r\n\x04\x04>', '\r\n>>> ', 'soft reboot', 'OK\x04OSError: 28\r\n\x04>', 'OK\x04Traceback\r\n\x04>', '\xff\x00\x80', 'x'.repeat(400), ''] as const; // prettier-ignore

  it(`never hangs and never fails but with a problem of its own: ${fuzzRuns} dialogues`, async () => {
    const seen = new Map<string, number>();
    for (let seed = 0; seed < fuzzRuns; seed++) {
      const below = chance(seed);
      // From pure rubbish to a device that is nearly right.
      const sense = below(101);
      let mode: 'raw' | 'friendly' = 'raw';
      const right = (sent: string): string => {
        if (sent.startsWith('\x02')) mode = 'friendly';
        if (sent.startsWith('\x01')) return BANNER;
        if (mode === 'friendly') return sent === '\x04' ? '\r\nMPY: soft reboot\r\n' : '\r\n>>> ';
        if (sent === '\x04' && below(4) === 0) return BANNER;
        return sent.endsWith('\x04') ? (['OK1\r\n\x04\x04>', 'OK-\r\n\x04\x04>', BANNER][below(3)] ?? '') : '';
      };
      const port = scripted((sent) => {
        if (below(400) === 0) return null;
        return below(100) < sense ? right(sent) : (TOKENS[below(TOKENS.length)] ?? '');
      });
      const kind = await problemOf(port);
      seen.set(kind, (seen.get(kind) ?? 0) + 1);
    }
    // The rubbish reaches far into the dialogue.
    for (const kind of ['silent', 'no-prompt', 'interrupted', 'garbled', 'stuck', 'exception', 'wrong-board']) {
      if (kind !== 'silent') expect([...seen.keys()]).toContain(kind);
    }
  });
});
