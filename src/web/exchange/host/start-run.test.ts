import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';

import { startRun } from './start-run';
import { fakeRun, settled } from './testing/fake-run';

beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', () => 0);
  vi.stubGlobal('cancelAnimationFrame', () => undefined);
});
afterEach(() => vi.unstubAllGlobals());

describe('a run that a host starts', () => {
  it.each([false, true])('is answered when it is under way (standing still: %s)', async (paused) => {
    const { run, host, say } = fakeRun();
    const answer = startRun({ run, host }, paused);
    await settled();
    expect(run.phase.value).toBe('starting');
    say({ type: 'started' });
    expect(await answer).toBeNull();
    expect(run.phase.value).toBe(paused ? 'paused' : 'running');
  });

  it('is answered as stopped, not as done, if somebody stops it before it began', async () => {
    for (const end of ['stop', 'reset'] as const) {
      const { run, host } = fakeRun();
      const answer = startRun({ run, host }, false);
      await settled();
      await run[end]();
      expect(await answer).toBe('The run was stopped before it began.');
    }
  });

  it('is answered with the reason if it could not start', async () => {
    const { run, host, say } = fakeRun();
    const answer = startRun({ run, host }, false);
    await settled();
    say({ type: 'failed', message: 'The robot stands in a wall.' });
    expect(await answer).toBe('The robot stands in a wall.');
  });

  it('is answered as stopped if a listener to its start stops it at once', async () => {
    const { run, host } = fakeRun();
    host.listen(({ type }) => {
      if (type === 'started') void run.stop();
    });
    expect(await startRun({ run, host }, false)).toBe('The run was stopped before it began.');
  });
});
