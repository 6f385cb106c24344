import type { Reader, Fields } from '#scene/reader';
import { sceneLimits } from '#scene/scene';
import { checkTypes, lightColors, lightPlaces, taskLimits, USUAL_WITHIN_DEG, type Check, type CheckKind } from './task';

type Type = CheckKind['type'];

/** Reads the checks of a task; each has an id of its own afterwards. */
export function readChecks(value: unknown, reader: Reader): readonly Check[] {
  const checks: Check[] = [];
  for (const [index, entry] of reader.list(value, 'task.checks', { min: 1, max: taskLimits.checks }).entries()) {
    const path = `task.checks[${String(index)}]`;
    const check = readCheck(entry, path, reader);
    const id = check.id === '' ? freeId(check.type, checks) : check.id;
    if (checks.some((other) => other.id === id))
      reader.report('duplicate-id', `${path}.id`, id, `another check has the id ${JSON.stringify(id)}.`);
    checks.push({ ...check, id });
  }
  return checks;
}

/** The name, or with a number if it is taken. */
export function freeId(name: string, others: readonly { readonly id: string }[]): string {
  for (let number = 1; ; number += 1) {
    const id = number === 1 ? name : `${name}-${String(number)}`;
    if (!others.some((other) => other.id === id)) return id;
  }
}

function readCheck(value: unknown, path: string, reader: Reader): Check {
  const given = typeof value === 'object' && value !== null && 'type' in value ? value.type : undefined;
  const type = checkTypes.find((known) => known === given);
  if (type === undefined) {
    reader.word(given ?? null, `${path}.type`, checkTypes, 'goals');
    return { type: 'goals', id: '', points: 1, needed: true };
  }
  const { names, read } = kinds[type];
  const fields = reader.fields(value, path, ['type', 'id', 'points', 'needed', ...names]);
  return {
    ...read(fields, path, reader),
    id: reader.text(fields['id'], `${path}.id`, taskLimits.idCharacters, ''),
    points: reader.number(fields['points'], `${path}.points`, taskLimits.points, 1),
    needed: reader.flag(fields['needed'], `${path}.needed`, true),
  };
}

interface Kind {
  readonly names: readonly string[];
  readonly read: (fields: Fields, path: string, reader: Reader) => CheckKind;
}

/** The fields of each type of check beyond the common ones. */
const kinds: Readonly<Record<Type, Kind>> = {
  goals: { names: [], read: () => ({ type: 'goals' }) },
  reach: {
    names: ['zones'],
    read: ({ zones = [] }, path, reader) => ({
      type: 'reach',
      zones: reader
        .list(zones, `${path}.zones`, taskLimits.zones)
        .map((zone, place) => reader.text(zone, `${path}.zones[${String(place)}]`, sceneLimits.idCharacters)),
    }),
  },
  stop: {
    names: ['seconds', 'zone', 'whole', 'heading', 'within'],
    read: (fields, path, reader) => {
      const { whole, heading, within } = fields;
      return {
        type: 'stop',
        seconds: secondsIn(fields, path, reader),
        zone: zoneIn(fields, path, reader),
        whole: reader.flag(whole, `${path}.whole`, false),
        heading: heading === undefined ? null : reader.number(heading, `${path}.heading`, sceneLimits.headingDeg),
        within: reader.number(within, `${path}.within`, taskLimits.withinDeg, USUAL_WITHIN_DEG),
      };
    },
  },
  stay: {
    names: ['seconds', 'zone'],
    read: (fields, path, reader) => ({
      type: 'stay',
      seconds: secondsIn(fields, path, reader),
      zone: zoneIn(fields, path, reader),
    }),
  },
  laps: {
    names: ['count'],
    read: ({ count }, path, reader) => ({ type: 'laps', count: reader.whole(count, `${path}.count`, taskLimits.laps) }),
  },
  checkpoints: {
    names: ['each'],
    read: ({ each }, path, reader) => ({
      type: 'checkpoints',
      each: each === undefined ? null : reader.number(each, `${path}.each`, taskLimits.points),
    }),
  },
  belongs: {
    names: ['object', 'zone'],
    read: ({ object, zone }, path, reader) => ({
      type: 'belongs',
      object: reader.text(object, `${path}.object`, sceneLimits.idCharacters),
      zone: reader.text(zone, `${path}.zone`, sceneLimits.idCharacters),
    }),
  },
  covered: {
    names: ['percent', 'zone'],
    read: (fields, path, reader) => ({
      type: 'covered',
      percent: reader.number(fields['percent'], `${path}.percent`, taskLimits.percent),
      zone: zoneIn(fields, path, reader),
    }),
  },
  tiles: {
    names: ['count'],
    read: ({ count }, path, reader) => ({
      type: 'tiles',
      count: reader.whole(count, `${path}.count`, taskLimits.tiles),
    }),
  },
  score: {
    names: ['least'],
    read: ({ least }, path, reader) => ({
      type: 'score',
      least: reader.whole(least, `${path}.least`, taskLimits.score),
    }),
  },
  touches: {
    names: ['most'],
    read: ({ most }, path, reader) => ({
      type: 'touches',
      most: reader.whole(most, `${path}.most`, taskLimits.touches),
    }),
  },
  faster: {
    names: ['seconds'],
    read: (fields, path, reader) => ({ type: 'faster', seconds: secondsIn(fields, path, reader) }),
  },
  later: {
    names: ['seconds'],
    read: (fields, path, reader) => ({ type: 'later', seconds: secondsIn(fields, path, reader) }),
  },
  display: {
    names: ['image'],
    read: ({ image }, path, reader) => ({ type: 'display', image: readImage(image, `${path}.image`, reader) }),
  },
  light: {
    names: ['which', 'color'],
    read: ({ which, color }, path, reader) => ({
      type: 'light',
      which: reader.word(which, `${path}.which`, lightPlaces, 'any'),
      color: color === undefined ? null : reader.word(color, `${path}.color`, lightColors, 'red'),
    }),
  },
  sound: {
    names: ['hz'],
    read: ({ hz }, path, reader) => ({
      type: 'sound',
      hz: hz === undefined ? null : reader.number(hz, `${path}.hz`, taskLimits.hz),
    }),
  },
  console: {
    names: ['text'],
    read: (fields, path, reader) => ({ type: 'console', text: textIn(fields, path, reader) }),
  },
  radio: { names: ['text'], read: (fields, path, reader) => ({ type: 'radio', text: textIn(fields, path, reader) }) },
  log: {
    names: ['rows', 'column'],
    read: ({ rows, column }, path, reader) => ({
      type: 'log',
      rows: reader.whole(rows, `${path}.rows`, taskLimits.rows, 1),
      column: reader.text(column, `${path}.column`, taskLimits.textCharacters, ''),
    }),
  },
  loop: { names: [], read: () => ({ type: 'loop' }) },
  calls: {
    names: ['name'],
    read: ({ name }, path, reader) => {
      const said = reader.text(name, `${path}.name`, 100);
      if (typeof name === 'string' && !/^[\p{L}_][\p{L}\p{N}_]*(\.[\p{L}_][\p{L}\p{N}_]*)*$/u.test(said))
        reader.report('wrong-type', `${path}.name`, name, 'must be a name, such as irLeft or display.show.');
      return { type: 'calls', name: said };
    },
  },
  lines: {
    names: ['most'],
    read: ({ most }, path, reader) => ({ type: 'lines', most: reader.whole(most, `${path}.most`, taskLimits.lines) }),
  },
  delay: {
    names: ['most'],
    read: ({ most }, path, reader) => ({
      type: 'delay',
      most: reader.number(most, `${path}.most`, taskLimits.delayMs),
    }),
  },
};

const secondsIn = ({ seconds }: Fields, path: string, reader: Reader): number =>
  reader.number(seconds, `${path}.seconds`, { min: 0.1, max: taskLimits.seconds.max });

const zoneIn = ({ zone }: Fields, path: string, reader: Reader): string | null =>
  zone === undefined ? null : reader.text(zone, `${path}.zone`, sceneLimits.idCharacters);

function textIn({ text }: Fields, path: string, reader: Reader): string {
  const said = reader.text(text, `${path}.text`, taskLimits.textCharacters);
  if (text === '') reader.report('missing', `${path}.text`, text, 'must not be empty.');
  return said;
}

function readImage(value: unknown, path: string, reader: Reader): string {
  const image = reader.text(value, path, 29);
  if (typeof value === 'string' && !/^\d{5}(:\d{5}){4}$/.test(image))
    reader.report(
      'wrong-type',
      path,
      value,
      'must be five rows of five digits, such as 09090:99999:99999:09990:00900.',
    );
  return image;
}
