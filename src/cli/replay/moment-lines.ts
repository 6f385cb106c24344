import type { Moment } from '#tape/moment';

/** A moment for people: where the program is, its variables from the innermost function outwards, the robot. */
export function momentLines({ timeMs, file, line, stack, globals, robot }: Moment): readonly string[] {
  const place = file === null ? 'the program does not run' : `${file}, line ${line ?? 0}`;
  return [
    `${timeMs / 1000} s: ${place}`,
    ...stack.flatMap((entry) => [
      `  ${entry.function} (${entry.file}, line ${entry.line})`,
      ...variables(entry.locals),
    ]),
    ...(Object.keys(globals).length > 0 ? ['  globals', ...variables(globals)] : []),
    ...(robot ? [`  robot: x ${robot.xMm} mm, y ${robot.yMm} mm, ${robot.headingDeg}°`] : []),
  ];
}

const variables = (shown: Moment['globals']): readonly string[] =>
  Object.entries(shown).map(([name, { type, text }]) => `    ${name} = ${text} (${type})`);
