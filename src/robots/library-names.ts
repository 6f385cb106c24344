import { fn, object, withWordsOf } from '#reference/table';

/** The names by which the libraries of all these robots drive. */
export const drivingNames = {
  forward: fn('() -> None'),
  backward: fn('() -> None'),
  left: fn('() -> None'),
  right: fn('() -> None'),
  leftArc: fn('(radius: float) -> None'),
  rightArc: fn('(radius: float) -> None'),
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
