import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { watch } from 'vue';

import { createSettings } from './settings-model';

describe('settings in the page of a host', () => {
  beforeEach(() => vi.stubGlobal('navigator', { languages: ['de'] }));
  afterEach(() => vi.unstubAllGlobals());

  it('hold as the host says and are not stored', () => {
    const settings = createSettings();
    settings.hold({ speed: 8, seed: 3 });
    expect(settings.current.value).toMatchObject({ speed: 8, seed: 3 });
    expect(settings.own.value).toMatchObject({ speed: 1, seed: 1 });
  });

  it('are stored where the pupil chooses another value, and only there', () => {
    const settings = createSettings({ speed: 8, seed: 3 });
    settings.change({ speed: 2, seed: 3 });
    expect(settings.current.value).toMatchObject({ speed: 2, seed: 3 });
    expect(settings.own.value).toMatchObject({ speed: 2, seed: 1 });
    settings.hold({ speed: 4 });
    expect(settings.own.value.speed).toBe(2);
  });

  it('are stored in part where the rest of a value is the host’s, which goes on holding', () => {
    const claw = { 'maqueen-lite': { S1: 'claw' } };
    const both = { 'maqueen-lite': { S1: 'claw', S2: 'claw' } };
    const settings = createSettings({ robotOptions: claw });
    const seen: unknown[] = [];
    watch(settings.current, ({ robotOptions }) => seen.push(robotOptions), { flush: 'sync' });
    settings.change({ robotOptions: both }, { robotOptions: { 'maqueen-lite': { S2: 'claw' } } });
    expect(settings.current.value.robotOptions).toEqual(both);
    expect(settings.own.value.robotOptions).toEqual({ 'maqueen-lite': { S2: 'claw' } });
    for (const value of seen) expect(value).toEqual(both);
  });
});
