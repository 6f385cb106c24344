import { spawnSync } from 'node:child_process';
import { describe, expect, it } from 'vitest';

describe('the pages of the motor laws', () => {
  it('are what the fit writes today', () => {
    const { status, stderr } = spawnSync(process.execPath, ['scripts/fit-motor-law.mjs', '--check'], {
      encoding: 'utf8',
    });
    expect(stderr).toBe('');
    expect(status).toBe(0);
  });
});
