import { fn, object, range, within, withWordsOf } from '#reference/table';

/** A radius in metres. Chosen: a wider arc than 3 m is straight on any table or floor of a class. */
export const metres = { least: 0, most: 3, unit: 'm' } as const;

/** Waiting, in ms. */
export const delay = within({ ms: { least: 0 } }, fn('(ms: float) -> None'));

/** Something that is on (1) or off (0). */
export const switched = (parameter: string): ReturnType<typeof fn> =>
  within({ [parameter]: range(0, 1) }, fn(`(${parameter}: int) -> None`));

/** The parts of a colour. */
export const color = { red: range(0, 255), green: range(0, 255), blue: range(0, 255) };

/** The angle of a servo, in degrees. */
export const servo = within({ angle: range(0, 180) }, fn('(servo: str, angle: int) -> None'));

/** The names by which the libraries of all these robots drive. */
export const drivingNames = {
  forward: fn('() -> None'),
  backward: fn('() -> None'),
  left: fn('() -> None'),
  right: fn('() -> None'),
  leftArc: within({ radius: metres }, fn('(radius: float) -> None')),
  rightArc: within({ radius: metres }, fn('(radius: float) -> None')),
  stop: fn('() -> None'),
};

/** Names that set up TigerJython's own simulation; the words on them are those of the library's `RobotContext`. */
export function tigerJythonNames(library: string) {
  const told = withWordsOf(`${library}.RobotContext`, fn('(*arguments) -> None'));
  return {
    RobotContext: object({
      enableTrace: told,
      enableRotCenter: told,
      setStartPosition: told,
      setStartDirection: told,
      useBackground: told,
      useObstacle: told,
    }),
    setBeamAreaColor: told,
    setProximityCircleColor: told,
    setMeshTriangleColor: told,
    eraseBeamArea: told,
  };
}
