"""The suite `mq-eval`: a fixed, versioned evaluation whose results can be compared between users."""
