// Written with its module.
