import type { Texts } from './languages';

/** A property of a robot that can be chosen: what is on a servo port, how a sensor of its series behaves. */
export interface Option {
  /** Used in course files and on the command line. */
  readonly id: string;
  readonly title: Texts;
  /** One sentence on its effect, where the title does not say it. */
  readonly about?: Texts;
  /** For people who know the robot's series: shown where they look for it, not to all pupils. */
  readonly isExpert?: boolean;
  /** Shown only while another option has one of these choices; it may be set all the same. */
  readonly onlyWith?: { readonly option: string; readonly choices: readonly string[] };
  /** At least two; the first is the default. */
  readonly choices: readonly OptionChoice[];
}

/** One of an option's values. */
export interface OptionChoice {
  readonly id: string;
  readonly title: Texts;
}

/** The words of an option and of its choices. */
interface OptionWords<Choice extends string> {
  readonly title: Texts;
  readonly about?: Texts;
  readonly choices: Readonly<Record<Choice, Texts>>;
}

/** An option whose choices have words of their own; the first of them is the default. */
export function optionOf<Choice extends string>(
  id: string,
  { title, about, choices }: OptionWords<Choice>,
  ids: readonly Choice[],
  more: Pick<Option, 'isExpert' | 'onlyWith'> = {},
): Option {
  return {
    ...{ id, title },
    ...(about === undefined ? {} : { about }),
    ...more,
    choices: ids.map((choice) => ({ id: choice, title: choices[choice] })),
  };
}

/** Chosen values: id of an option → id of a choice. */
export type OptionValues = Readonly<Record<string, string>>;

/** True if an option matters with these values. */
export const isShownWith = ({ onlyWith }: Option, values: OptionValues): boolean =>
  onlyWith === undefined || onlyWith.choices.includes(values[onlyWith.option] ?? '');

/** Every option with its value: the chosen one if it is one of the choices, else the first. */
export function completeOptions(options: readonly Option[], chosen: OptionValues): OptionValues {
  const value = ({ id, choices }: Option): string =>
    (choices.find((choice) => choice.id === chosen[id]) ?? choices[0])?.id ?? '';
  return Object.fromEntries(options.map((option) => [option.id, value(option)]));
}

/**
 * The mistake in chosen values, as a message naming option, value and the existing choices; `null` if there is no
 * mistake.
 */
export function optionProblem(options: readonly Option[], chosen: OptionValues): string | null {
  for (const [id, value] of Object.entries(chosen)) {
    const option = options.find((candidate) => candidate.id === id);
    if (option === undefined) return `there is no option "${id}". Known: ${idsOf(options) || 'none'}.`;
    if (!option.choices.some((choice) => choice.id === value))
      return `"${value}" is no choice of ${id}. Known: ${idsOf(option.choices)}.`;
  }
  return null;
}

const idsOf = (things: readonly { readonly id: string }[]): string => things.map(({ id }) => id).join(', ');
