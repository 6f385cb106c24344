import { sceneDefaults, sceneLimits, type Chase, type Mover, type Point } from '../../scene';
import { waitsProperty } from '../mover-way';
import type { KindReader } from './kind-reader';
import { readBody, readHeight, readObjectId, readPlace, unread, type Unread } from './unread';

/** The properties of a path; a mover that chases robots has none of them. */
const wayProperties = ['stops', 'waits', 'loops', 'phase'] as const;

export const mover: KindReader<Mover> = {
  properties: ['at', 'to', 'size', 'angle', 'round', 'height', 'speed', 'spiked', ...wayProperties, 'spin', 'chases'],
  read(given) {
    const { reader, at } = given;
    const box = readBody(given);
    const chases = at('chases')[0] !== undefined;
    const spin = reader.whole(...at('spin'), sceneLimits.spinDegS, 0);
    const hasPlaceOnly = at('to')[0] === undefined && (chases || spin !== 0);
    return {
      type: 'mover',
      ...box,
      ...readHeight(given),
      to: hasPlaceOnly ? box.at : readPlace(given, 'to'),
      speed: reader.whole(...at('speed'), sceneLimits.speedMmS, sceneDefaults.speed),
      spiked: reader.flag(...at('spiked'), sceneDefaults.spiked),
      ...(chases ? readChaser(given) : readWay(given)),
      ...(spin === 0 ? {} : { spin }),
    };
  },
};

function readWay({ reader, at }: Unread): Pick<Mover, (typeof wayProperties)[number]> {
  const [given, path] = at('stops');
  const stops =
    given === undefined
      ? []
      : reader
          .list(given, path, { min: 0, max: sceneLimits.stops - 2 })
          .map((stop, index) => reader.point(stop, `${path}[${String(index)}]`, sceneLimits.placeMm));
  const [waits, waitsPath] = at('waits');
  const phase = reader.number(...at('phase'), sceneLimits.phaseSeconds, 0);
  return {
    ...(stops.length === 0 ? {} : { stops }),
    ...(waits === undefined ? {} : waitsProperty(readWaits(waits, waitsPath, stops, reader))),
    ...(reader.flag(...at('loops'), false) ? { loops: true } : {}),
    ...(phase === 0 ? {} : { phase }),
  };
}

const readWaits = (
  value: unknown,
  path: string,
  stops: readonly Point[],
  reader: Unread['reader'],
): readonly number[] =>
  reader
    .list(value, path, { min: 0, max: 2 + stops.length })
    .map((wait, index) => reader.number(wait, `${path}[${String(index)}]`, sceneLimits.waitSeconds));

function readChaser({ reader, at }: Unread): Pick<Mover, 'chases'> {
  for (const name of wayProperties) {
    const [value, path] = at(name);
    if (value === undefined) continue;
    const known = mover.properties.filter((property) => !wayProperties.some((own) => own === property)).join(', ');
    reader.report('unknown-property', path, value, 'what chases robots has no way. Leave this out.', { known });
  }
  const [value, path] = at('chases');
  const fields = unread(reader.fields(value, path, ['zone', 'reach']), path, 0, reader);
  const [zone, reach] = [fields.at('zone'), fields.at('reach')];
  const chases: Chase = {
    ...(zone[0] === undefined ? {} : { zone: readObjectId(...zone, reader) }),
    ...(reach[0] === undefined ? {} : { reach: reader.whole(...reach, sceneLimits.reachMm) }),
  };
  return { chases };
}
