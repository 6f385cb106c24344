import type { Option } from '#core/option';
import type { Texts } from '#core/texts';

/** What can hang on a servo port, by id, the most usual first; `none` leaves it empty. */
export const attachmentTitles = {
  none: { de: 'nichts', fr: 'rien', it: 'niente', en: 'nothing' },
  claw: { de: 'Greifer', fr: 'pince', it: 'pinza', en: 'claw' },
  forklift: { de: 'Gabelstapler', fr: 'chariot élévateur', it: 'muletto', en: 'forklift' },
  loader: { de: 'Schaufel', fr: 'pelle', it: 'pala', en: 'loader' },
  push: {
    de: 'Schieber mit drehbarem Ultraschall',
    fr: 'poussoir avec ultrasons pivotants',
    it: 'spintore con ultrasuoni girevoli',
    en: 'pusher with turning ultrasonic',
  },
} as const satisfies Readonly<Record<string, Texts>>;

/** The options of a robot's servo ports: what hangs on each. Light: the page loads it before anything runs. */
export function attachmentOptions(ports: readonly string[]): readonly Option[] {
  const choices = Object.entries(attachmentTitles).map(([id, title]) => ({ id, title }));
  return ports.map((port) => {
    const name = `Servo ${port}`; // the same word in every language
    return { id: port, title: { de: name, fr: name, it: name, en: name }, choices };
  });
}
