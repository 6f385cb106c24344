import type { BoardApi, Feature } from '#core/board-api';
import type { Texts } from '#core/languages';

/** The kind of a name. An `object` has its own names and no class that programs could call (`display`, `i2c`). */
export type EntryKind = 'function' | 'type' | 'exception' | 'value' | 'object' | 'module' | 'keyword';

/** One public name. */
export interface Entry {
  readonly kind: EntryKind;
  /** Its signatures without the name: `(x: int, y: int) -> int`. */
  readonly calls: readonly string[];
  /** Its type, a name in its own module, in `microbit` or in `builtins`: `int`, `list[Image]`. */
  readonly type: string | null;
  /** Its attributes; for a type, those of its instances, too. */
  readonly members: Names;
  /** Base types, named like `type`. */
  readonly bases: readonly string[];
  /** Boards that have it; all when left out. */
  readonly boards?: readonly BoardApi[];
  /** Only firmware with this feature has it. */
  readonly feature?: Feature;
  /** Type hints of other editors list it, but the firmware does not have it: it is never offered. */
  readonly absent?: true;
  /** Key of its words, if not its own name. */
  readonly text?: string;
  /** Sensible values of its parameters, by their names. */
  readonly limits?: Limits;
}

/** The range of a number that makes sense for a parameter. Beyond it nothing fails, but hardly anybody means it. */
export interface Limit {
  readonly least: number;
  /** Left out: there is none. */
  readonly most?: number;
  /** Metres: a larger number was most likely meant in cm. */
  readonly unit?: 'm';
}

export type Limits = Readonly<Record<string, Limit>>;

export type Names = Readonly<Record<string, Entry>>;

/** A module that programs can import. */
export interface ReferenceModule {
  /** Its main name; usually also the prefix of its words' keys (`keyOf`). */
  readonly name: string;
  /** Other names for the same module: `utime` for `time`. */
  readonly aliases: readonly string[];
  readonly boards?: readonly BoardApi[];
  readonly names: Names;
}

/** A robot's libraries and their words. */
export interface RobotReference {
  /** Id of the robot. */
  readonly robot: string;
  readonly modules: readonly ReferenceModule[];
  /** Short words on the modules' names, by the names' keys. */
  readonly texts: Readonly<Record<string, Texts>>;
  /** Calls that do what another call's name says, also one that the library lacks: name → the name of the right call. */
  readonly misnamed?: Readonly<Record<string, string>>;
}
