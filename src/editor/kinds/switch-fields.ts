import { switchLimits, switchPins, wayOfSwitching, type Switching, type SwitchWay } from '#scene/kinds/switching';
import type { Field } from '../object-fields';

/** The switching that a newly chosen way begins with. */
const FIRST: Readonly<Record<SwitchWay, Switching>> = {
  hand: 'hand',
  time: { time: [3, 3] },
  radio: { radio: ['on', 'off'] },
  button: { button: 'a' },
  pin: { pin: 'P0' },
};

/**
 * The fields of how something is switched.
 *
 * @param ways that can be chosen; `always` stands for `undefined`
 * @param first what a newly chosen way begins with, where it differs from `FIRST`
 */
export function switchFields<O>(
  switching: Switching | undefined,
  ways: readonly (SwitchWay | 'always')[],
  withSwitching: (now: Switching | undefined) => O,
  first: Partial<typeof FIRST> = {},
): readonly Field<O>[] {
  const way = switching === undefined ? 'always' : wayOfSwitching(switching);
  return [
    {
      ...{ kind: 'choice', name: 'switching', value: way, choices: ways },
      with: (chosen: SwitchWay | 'always') =>
        withSwitching(chosen === 'always' ? undefined : (first[chosen] ?? FIRST[chosen])),
    },
    ...(switching === undefined || switching === 'hand' ? [] : ownFields(switching, withSwitching)),
  ];
}

function ownFields<O>(
  switching: Exclude<Switching, 'hand'>,
  withSwitching: (now: Switching) => O,
): readonly Field<O>[] {
  if ('time' in switching) {
    const { time } = switching;
    const seconds = { kind: 'number', ...switchLimits.seconds, step: 0.5, unit: 's' } as const;
    return [
      { ...seconds, name: 'onSeconds', value: time[0], with: (on: number) => withSwitching({ time: [on, time[1]] }) },
      {
        ...seconds,
        name: 'offSeconds',
        value: time[1],
        with: (off: number) => withSwitching({ time: [time[0], off] }),
      },
    ];
  }
  if ('radio' in switching) {
    const { radio } = switching;
    const text = { kind: 'text', maxCharacters: switchLimits.characters } as const;
    const unlessEmpty = (words: string, now: Switching): O | null => (words === '' ? null : withSwitching(now));
    return [
      { ...text, name: 'onText', value: radio[0], with: (on: string) => unlessEmpty(on, { radio: [on, radio[1]] }) },
      {
        ...text,
        name: 'offText',
        value: radio[1],
        with: (off: string) => unlessEmpty(off, { radio: [radio[0], off] }),
      },
    ];
  }
  if ('button' in switching)
    return [
      {
        ...{ kind: 'choice', name: 'switchButton', value: switching.button, choices: ['a', 'b'] },
        with: (button: 'a' | 'b') => withSwitching({ button }),
      },
    ];
  return [
    {
      ...{ kind: 'choice', name: 'switchPin', value: switching.pin, choices: switchPins },
      with: (pin: (typeof switchPins)[number]) => withSwitching({ pin }),
    },
  ];
}
