import { describe, expect, it } from 'vitest';

import { robotTypes } from '#robots/index';
import { idealTraits } from '#robots/traits';
import { deviceSettings, seedOf } from '../hardware/hardware';
import { defaultSettings, settingsFromText } from './settings';

const fallback = defaultSettings('de');
const read = (settings: object) => settingsFromText(JSON.stringify(settings), fallback);
const [lite] = robotTypes;
const echo = lite!.options.find(({ id }) => id === 'echo')!;

describe('what the settings keep about robots', () => {
  it('is what was chosen, by the robot and its option', () => {
    const robotOptions = { [lite!.id]: { echo: echo.choices[1]!.id } };
    expect(read({ robotOptions }).robotOptions).toEqual(robotOptions);
    expect(settingsFromText(JSON.stringify({ ...fallback, robotOptions }), fallback)).toEqual({ ...fallback, robotOptions }); // prettier-ignore
  });

  it('leaves out robots, options and choices that this version does not have', () => {
    expect(read({ robotOptions: { tank: { gun: 'long' } } }).robotOptions).toEqual({});
    expect(read({ robotOptions: { [lite!.id]: { echo: 'loud', colour: 'red' } } }).robotOptions).toEqual({});
    expect(read({ robotOptions: { [lite!.id]: { echo: 7 } } }).robotOptions).toEqual({});
  });

  it('is nothing where the stored value makes no sense', () => {
    for (const robotOptions of [null, 3, 'x', [], { [lite!.id]: null }, { [lite!.id]: 'claw' }])
      expect(read({ robotOptions }).robotOptions, JSON.stringify(robotOptions)).toEqual({});
  });
});

describe('the robot that the pupil has measured', () => {
  const mine = {
    ...{ name: 'Röbi', robot: lite!.id, used: true },
    measured: { drives: { slow: null, usual: null, fast: null }, turnDeg: null, echoesMm: [null, null], line: {} },
    traits: idealTraits,
  };

  it('is kept as it is', () => {
    expect(read({ myRobot: mine }).myRobot).toEqual(mine);
  });

  it('is none where what is stored is no robot, or one that this version does not have', () => {
    const { motors } = idealTraits;
    for (const senseless of [
      ...[null, 3, 'Röbi', {}, { ...mine, robot: 'tank' }, { ...mine, used: 'yes' }, { ...mine, measured: {} }],
      { ...mine, traits: { ...idealTraits, motors: { ...motors, charge: 'full' } } },
      { ...mine, traits: { ...idealTraits, ultrasonic: undefined } },
    ])
      expect(read({ myRobot: senseless }).myRobot, JSON.stringify(senseless)).toBeNull();
  });
});

describe('the reality', () => {
  it('is ideal on a first visit and a number from 0 to 1 afterwards', () => {
    expect(fallback.reality).toBe(0);
    expect([0, 0.25, 1].map((reality) => read({ reality }).reality)).toEqual([0, 0.25, 1]);
    expect([-1, 1.5, '1', null, 1e999].map((reality) => read({ reality }).reality)).toEqual([0, 0, 0, 0, 0]);
  });
});

describe('the number of the used robot', () => {
  it('is 1 on a first visit and a whole number from 1 to 9999 afterwards', () => {
    expect(fallback.seed).toBe(1);
    expect([1, 7, 9999].map((seed) => read({ seed }).seed)).toEqual([1, 7, 9999]);
    expect([0, -3, 10_000, 2.5, '7', null].map((seed) => read({ seed }).seed)).toEqual([1, 1, 1, 1, 1, 1]);
  });

  it('makes another run for a used robot, none for the ideal one, which has no number', () => {
    const used = { ...fallback, reality: 0.5 };
    expect([seedOf({ ...used, seed: 7 }), seedOf({ ...fallback, seed: 7 })]).toEqual([7, 1]);
    expect(deviceSettings({ ...used, seed: 7 })).not.toEqual(deviceSettings(used));
    expect(deviceSettings({ ...fallback, seed: 7 })).toEqual(deviceSettings(fallback));
  });
});

describe('the greeting of a first visit', () => {
  it('waits for an answer on a first visit alone: whoever has settings already knows the app', () => {
    expect(fallback.welcomed).toBe(false);
    expect(read({ language: 'fr' }).welcomed).toBe(true);
  });

  it('is asked again where the pupil has changed something else, and not once it was answered', () => {
    expect(read({ ...fallback, theme: 'dark' }).welcomed).toBe(false);
    expect(read({ ...fallback, welcomed: true }).welcomed).toBe(true);
  });
});

describe('the place where the tour was left', () => {
  it('is kept as the name of its step, and nothing else is taken for one', () => {
    expect(fallback.tourStep).toBeNull();
    expect(read({ tourStep: 'arena' }).tourStep).toBe('arena');
    for (const tourStep of [3, true, {}, null]) expect(read({ tourStep }).tourStep).toBeNull();
  });
});
