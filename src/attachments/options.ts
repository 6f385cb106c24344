import type { Option } from '#core/option';
import type { Texts } from '#core/texts';

/** What can hang on a servo port, by id, the most usual first; `none` leaves it empty. */
export const attachmentTitles = {
  none: { de: 'nichts', en: 'nothing' },
  claw: { de: 'Greifer', en: 'claw' },
  forklift: { de: 'Gabelstapler', en: 'forklift' },
  loader: { de: 'Schaufel', en: 'loader' },
  push: { de: 'Schieber mit drehbarem Ultraschall', en: 'pusher with turning ultrasonic' },
} as const satisfies Readonly<Record<string, Texts>>;

/** The options of a robot's servo ports: what hangs on each. Light: the page loads it before anything runs. */
export function attachmentOptions(ports: readonly string[]): readonly Option[] {
  const choices = Object.entries(attachmentTitles).map(([id, title]) => ({ id, title }));
  return ports.map((port) => ({ id: port, title: { de: `Servo ${port}`, en: `Servo ${port}` }, choices }));
}
