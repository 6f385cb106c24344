import type { ProgramNames } from '#python/scopes';
import type { PythonText, SyntaxNode } from '#python/tree';

import type { Kind } from './kinds';
import type { RuleId, Severity } from './rule-table';
import type { Device } from './finding';

/** A finding of a rule. Missing fields are empty; its severity is the rule's. */
export interface Mark {
  readonly node: SyntaxNode;
  readonly rule: RuleId;
  readonly name?: string;
  readonly instead?: string;
  readonly severity?: Severity;
}

/** The program that a rule looks at, and its context. */
export interface Context {
  readonly file: PythonText;
  readonly names: ProgramNames;
  readonly device: Device;
  kindOf(node: SyntaxNode): Kind;
  /** True if an attribute of this name is defined anywhere in the pupil's files. */
  isOwnAttribute(name: string): boolean;
  /** Whether a name is defined in this file, or may come from a file of the pupil's by `import *`. */
  isOwnName(name: string): boolean;
  /** True if a module is one of the pupil's files. */
  isOwnModule(name: string): boolean;
  report(mark: Mark): void;
}

/** Looks at one node of the tree. */
export type Visitor = (node: SyntaxNode, context: Context) => void;

/** Rules by the name of the node they look at. */
export type Visitors = Readonly<Record<string, Visitor>>;
