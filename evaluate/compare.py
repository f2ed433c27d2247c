"""Compare several policies with each other and with the scripted gaits, on the same episodes.

python evaluate/compare.py runs/<one> runs/<other>
python evaluate/compare.py flat runs/latest --video results/side.mp4
"""

import argparse
import shlex
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import add_evaluation_options, plain_warnings, tell_results
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.evaluation.comparison import compare_policies
from quadruped_env.files import free_path
from quadruped_env.reporting.films.video import prepare_video, save_film
from quadruped_env.reporting.pages.page import summary_table
from quadruped_env.reporting.pages.run_comparison import films, find_subjects, headline, write_comparison
from quadruped_env.reporting.results import prepare_output


def main() -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("runs", nargs="+", metavar="RUN", help="two or more: a run's directory, or 'flat'")
    add_evaluation_options(parser, "results/comparison, or the next free number")
    args = parser.parse_args()
    output = args.output or free_path(Path("results", "comparison"))
    try:
        with plain_warnings("compare.py"):
            subjects = find_subjects(args.runs, output)
        prepare_video(args.video, args.overwrite)
        prepare_output(output)
        policies = {name: subject.policy for name, subject in subjects.items()}
        comparison = compare_policies(policies, args.seeds, args.seconds, progress=ProgressLine("running"))
        typed = shlex.join(subject.source for subject in subjects.values())
        report, numbers, missing = write_comparison(
            subjects,
            comparison,
            output,
            f"python evaluate/compare.py {typed} --seeds {args.seeds} --seconds {args.seconds:g}",
            with_video=not args.no_video,
            progress=ProgressLine("filming"),
        )
        if args.video:
            save_film(args.video, films(comparison, list(subjects)), ProgressLine("filming"))
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(2)
    print(f"\n{summary_table(comparison)}\n\n{headline(comparison, list(subjects))}\n")
    tell_results(report, numbers, missing, args.video)


if __name__ == "__main__":
    main()
