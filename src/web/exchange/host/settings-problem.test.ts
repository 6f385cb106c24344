import { describe, expect, it } from 'vitest';

import { PARTS, type HostSettings } from '#embed/simulator';
import { heldSettings } from '../../session/visit/held-settings';
import { settingsProblem } from './settings-problem';

describe('what a host sets', () => {
  it('is done when the app has all of it', () => {
    const wish: HostSettings = { language: 'fr', speed: 'max', device: 'calliope-mini-3', robot: 'callibot', seed: 7 };
    expect(settingsProblem(wish)).toBeNull();
    expect(settingsProblem({})).toBeNull();
  });

  it('is refused with the place, the value and what there is', () => {
    expect(settingsProblem({ device: 'arduino' })).toBe(
      'device: "arduino" is not one of auto, microbit-v2, calliope-mini-3, calliope-mini-2.',
    );
    expect(settingsProblem({ robot: 'tank' })).toMatch(/^robot: "tank" is not one of auto, none, maqueen-lite, /);
    expect(settingsProblem({ reality: 2 })).toBe('reality: 2 is not within 0 … 1.');
    expect(settingsProblem({ seed: 0.5 })).toBe('seed: 0.5 is no whole number within 1 … 9999.');
  });

  it('is refused where a message claims what no type allows', () => {
    const wish = JSON.parse('{ "language": "tlh", "parts": ["board", "kitchen"] }') as HostSettings;
    expect(settingsProblem(wish)).toBe('language: "tlh" is not one of de, fr, it, en.');
    expect(settingsProblem({ ...wish, language: 'de' })).toMatch(/^parts: "kitchen" is not one of bar, /);
  });

  it('reaches the settings of the app; parts and labels are the page’s own affair', () => {
    expect(heldSettings({ language: 'it', labels: { 'button-a': 'A' } })).toEqual({ language: 'it' });
    expect(heldSettings({ parts: ['arena'] })).toEqual({ showBoard: true, showArena: true, showTools: false });
  });

  it('unfolds the tools only where it says so: a page without its bar is otherwise as it is', () => {
    const withoutBar = PARTS.filter((part) => part !== 'bar');
    expect(heldSettings({ parts: withoutBar })).toMatchObject({ showTools: false });
    expect(heldSettings({ parts: PARTS })).toMatchObject({ showTools: false });
    expect(heldSettings({ parts: ['arena', 'tools'] })).toMatchObject({ showTools: true });
  });
});
