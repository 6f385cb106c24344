/**
 * Words that are rightly the same as in English, by language. A text of nothing but them may be the English one;
 * whatever else is the same has been forgotten.
 *
 * @type {Readonly<Record<'fr' | 'it', ReadonlySet<string>>>}
 */
export const sameWords = {
  fr: new Set(
    (
      'apostrophe auto bot buzzer calli code console csv apriltag apriltags cyan date distance firmware lidar magenta max menu message messages min missions module modules moment obstacle obstacles orange page parcours ' +
      'pause pdf place png point points radio rectangle repl robot section servo servos signature simulation slalom suggestions svg tcs tunnel tunnels variable variables visible zone zones'
    ).split(' '),
  ),
  it: new Set(
    'apriltag arena auto bot calli console csv display file firmware gamepad garage lidar link magenta max menu microcomputer min parcours pdf pin png radio repl robot servo slalom svg tcs timer tunnel'.split(
      ' ',
    ),
  ),
};
