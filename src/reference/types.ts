import type { BoardApi, Feature } from '#core/board-api';
import type { Language } from '#core/texts';

/** What a name stands for. An `object` has its own names and no class that programs could call (`display`, `i2c`). */
export type EntryKind = 'function' | 'type' | 'exception' | 'value' | 'object' | 'module' | 'keyword';

/** One public name. */
export interface Entry {
  readonly kind: EntryKind;
  /** How it is called, without its name: `(x: int, y: int) -> int`. Several when it can be called in several ways. */
  readonly calls: readonly string[];
  /** What a value is: a type's name in its own module, in `microbit` or in `builtins`: `int`, `list[Image]`. */
  readonly type: string | null;
  /** Names behind its dot: of a type also those of its instances. */
  readonly members: Names;
  /** Types whose names it has too, found like `type`. */
  readonly bases: readonly string[];
  /** Boards that have it; all when left out. */
  readonly boards?: readonly BoardApi[];
  /** It is in firmwares with this feature only. */
  readonly feature?: Feature;
  /** Type hints of other editors name it, the firmware does not have it: it is never offered. */
  readonly absent?: true;
  /** Its words stand under this name instead of its own. */
  readonly text?: string;
}

export type Names = Readonly<Record<string, Entry>>;

/** A module that programs can import. */
export interface ReferenceModule {
  /** Its first name, which is the beginning of its texts' names too. */
  readonly name: string;
  /** Other names that import the same: `utime` for `time`. */
  readonly aliases: readonly string[];
  readonly boards?: readonly BoardApi[];
  readonly names: Names;
}

/** A robot's libraries and their words. */
export interface RobotReference {
  /** Id of the robot. */
  readonly robot: string;
  readonly modules: readonly ReferenceModule[];
  readonly texts: Readonly<Record<Language, Readonly<Record<string, string>>>>;
}
