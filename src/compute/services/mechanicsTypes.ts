import type { StateOfSystem, Terms } from '../../core/mechanics/terms.ts';
import type { ExchangeFormat, Exchanged } from '../../core/exchange/index.ts';
import type { Ask } from '../../core/lessons/lesson.ts';
import type { Scenario } from '../../core/scenario/types.ts';
import type { Call } from '../remote/protocol.ts';

export interface MechanicsCalls {
  /** A system's equations evaluated at one state. */
  'mechanics.terms': Call<StateOfSystem, Terms>;
  /** The answer of a lesson's question. */
  'mechanics.answer': Call<{ scenario: Scenario; ask: Ask }, number>;
  /** A scenario's system as a file of another tool. */
  'mechanics.export': Call<{ scenario: Scenario; format: ExchangeFormat }, Exchanged>;
}
