"""Evaluate a trained policy against the scripted gaits, and write its report.

python evaluate/policy.py                    the latest run in runs/, or the shipped policy
python evaluate/policy.py runs/<name>        a run; of one that was killed, its last checkpoint
python evaluate/policy.py flat               the shipped policy
"""

import argparse
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))  # a Python without the package finds it here, and is told what to do

from quadruped_env import MissingExtraError, QuadrupedError
from quadruped_env._python import pasteable
from quadruped_env.cli.options import add_evaluation_options, plain_warnings, tell_results
from quadruped_env.cli.progress import ProgressLine
from quadruped_env.evaluation.comparison import compare
from quadruped_env.evaluation.subject import find_subject
from quadruped_env.evaluation.verdict import verdict
from quadruped_env.reporting.films.video import prepare_video, save_film
from quadruped_env.reporting.pages.evaluation_report import write_report
from quadruped_env.reporting.pages.page import summary_table
from quadruped_env.reporting.pages.pictures import filmed
from quadruped_env.reporting.results import prepare_output


def main(arguments: list[str] | None = None) -> None:
    """Run the program."""
    parser = argparse.ArgumentParser(
        description=pasteable(__doc__), formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("run", nargs="?", metavar="RUN", help="a run's directory, or 'flat'")
    add_evaluation_options(parser, "RUN/evaluation, or results/flat")
    args = parser.parse_args(arguments)
    try:
        with plain_warnings("policy.py"):
            subject = find_subject(args.run, args.output)
        prepare_output(subject.output)
        prepare_video(args.video, args.overwrite)
        print(f"evaluating {subject.name}")
        comparison = compare(subject.policy, args.seeds, args.seconds, progress=ProgressLine("running"))
        report, numbers, missing = write_report(
            subject,
            comparison,
            f"python evaluate/policy.py {subject.source} --seeds {args.seeds} --seconds {args.seconds:g}",
            with_video=not args.no_video,
            progress=ProgressLine("filming"),
        )
        if args.video:
            save_film(args.video, filmed(comparison), ProgressLine("filming"))
    except (QuadrupedError, MissingExtraError) as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(2)
    print(f"\n{summary_table(comparison)}\n\n{verdict(comparison).text()}\n")
    tell_results(report, numbers, missing, args.video)


if __name__ == "__main__":
    main()
