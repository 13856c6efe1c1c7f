import type { Case } from '../cases/case.ts';
import type { Sketch, Value } from '../geometry/drawing.ts';
import type { GeneratedEquations, GeneratedJacobians } from '../model/defineSystem.ts';
import type { SystemView } from '../model/system.ts';

/** What a system's folder gives to the registry. */
export interface SystemFolder {
  view: SystemView;
  cases: readonly Case[];
  /** `equations.generated.ts` */
  equations(): Promise<GeneratedEquations>;
  /** `jacobians.generated.ts` */
  jacobians(): Promise<GeneratedJacobians>;
  /** `accelerations.generated.json`, where the derivation has written one. */
  tape?(): Promise<{ default: unknown }>;
  /** `typeset.generated.json` */
  typeset(): Promise<{ default: unknown }>;
  /** `drawing.ts`; without it the bodies are drawn as plain markers. */
  drawing?(): Promise<{ draw(p: Value): Sketch }>;
  /** Parameters that shape the drawing, so that a change of another makes no new meshes; left out, any may. */
  shapedBy?: readonly string[];
}
