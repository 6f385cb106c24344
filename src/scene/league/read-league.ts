import { leagueLimits, leagueRules, tileHeadings, type League, type LeagueTile, type RescueZone } from './league';
import type { Reader } from '../reader';
import { sceneLimits } from '../scene';

/** Reads how a line is scored by the rules of a league; `null`: it is not. */
export function readLeague(value: unknown, path: string, reader: Reader): League | null {
  if (value === null) return null;
  const { rules, tiles, zone } = reader.fields(value, path, ['rules', 'tiles', 'zone']);
  if (rules === undefined) reader.wrongType(rules, `${path}.rules`, `one of ${leagueRules.join(', ')}`);
  const entries = reader.list(tiles, `${path}.tiles`, leagueLimits.tiles);
  return {
    rules: reader.word(rules, `${path}.rules`, leagueRules, 'line-2025'),
    tiles: entries.map((entry, index) => readTile(entry, `${path}.tiles[${String(index)}]`, reader)),
    ...(zone === undefined ? {} : { zone: readZone(zone, `${path}.zone`, reader) }),
  };
}

const counts = ['gaps', 'crossings', 'obstacles'] as const;
const flags = ['checkpoint', 'afterZone'] as const;

function readTile(value: unknown, path: string, reader: Reader): LeagueTile {
  const fields = reader.fields(value, path, ['at', 'heading', ...counts, ...flags]);
  const { at, heading = 0 } = fields;
  if (!tileHeadings.some((one) => one === heading)) {
    const known = tileHeadings.join(', ');
    reader.report('unknown-value', `${path}.heading`, heading, `must be one of ${known}.`, { known });
  }
  const given = Object.fromEntries<number | boolean>(
    [
      ...counts.map((name) => [name, reader.whole(fields[name], `${path}.${name}`, leagueLimits.perTile, 0)] as const),
      ...flags.map((name) => [name, reader.flag(fields[name], `${path}.${name}`, false)] as const),
    ].filter(([, said]) => said !== 0 && said !== false),
  ) as Omit<LeagueTile, 'at' | 'heading'>;
  return { at: reader.point(at, `${path}.at`, sceneLimits.placeMm), heading: Number(heading), ...given };
}

function readZone(value: unknown, path: string, reader: Reader): RescueZone {
  const { at, size } = reader.fields(value, path, ['at', 'size']);
  return {
    at: reader.point(at, `${path}.at`, sceneLimits.placeMm),
    size: reader.point(size, `${path}.size`, leagueLimits.zoneMm),
  };
}
