import type { Case } from '../cases/case.ts';
import type { Layout, Sketch, Value } from '../geometry/drawing.ts';
import type { GeneratedEquations } from '../model/defineSystem.ts';
import type { SystemView } from '../model/system.ts';

/** What a system's folder gives to the registry. */
export interface SystemFolder {
  view: SystemView;
  cases: readonly Case[];
  /** `equations.generated.ts` */
  equations(): Promise<GeneratedEquations>;
  /** `typeset.generated.json` */
  typeset(): Promise<{ default: unknown }>;
  /** `drawing.ts`; without it the bodies are drawn as plain markers. */
  drawing?(): Promise<{ draw(p: Value): Sketch }>;
  /** Meshes that lie beside the page in `models/`, so that the first view need not load the drawing. */
  shipped?: {
    /** Parameters that shape the meshes; where all have their defaults the files are loaded. */
    shapedBy: readonly string[];
    /** What the drawing says beside its meshes. */
    layout(p: Value): Layout;
  };
}
